// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/method/conformal_system.h"
#include "core/method/handle_paths.h"
#include "core/method/stepped_method.h"

namespace foldless {

/// Maps of bounded conformal distortion [Lip12], one cone program a step: the energy's minimum
/// subject to Cu = p and |f_z̄| ≤ k Re(e^{−iθ} f_z) on every triangle, k = (K − 1)/(K + 1), which
/// implies σ₁/σ₂ ≤ K and det J > 0 and is convex for a given frame θ. Then θ ← arg f_z, and
/// again, until the energy hardly falls.
///
/// The first frames decide whether there is such a map. With StartFrames::rest and
/// StartFrames::unconstrained they are given, and the first program may be proved infeasible.
/// StartFrames::continuation is not in [Lip12]: the handles go to their targets in steps, each with
/// the frames of the map before and taken only when its map is locally injective; first along
/// straight lines, and where that ends before the targets, along a similarity.
///
/// A map that meets all bounds may still wind twice round an interior vertex when it starts from
/// given frames. The problem's rest mesh has a bounding-box diagonal of about 1.
class BoundedConformal final : public SteppedMethod {
 public:
  /// Throws Error when the energy is none of dirichlet, lscm and arap, or cannot hold a part of
  /// the mesh.
  explicit BoundedConformal(const Problem& problem);

  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;

 private:
  StageTimes stage_times() const override { return system_.solver.times(); }

  /// One program's end: a map, or why there is none.
  struct Trial {
    ConeStatus status = ConeStatus::cancelled;
    Points u;
    std::string why;
    friend bool is_cancelled(const Trial& trial) { return trial.status == ConeStatus::cancelled; }
  };
  /// How far a path led.
  struct PathEnd {
    double lambda = 0;  ///< 1 at the targets
    Points u;           ///< the map there
    Trial last;         ///< why it led no farther
  };

  Steps<Outcome> solve();
  Steps<std::optional<Outcome>> solve_with_given_frames();
  Steps<std::optional<Outcome>> continue_to_targets();
  Steps<PathEnd> follow(const Points& start, const HandlePaths& path);
  Steps<Outcome> improve();

  bool find_first_frames(const std::stop_token& token);
  Trial solve_program(const Points& handle_positions, double tolerance,
                      const std::stop_token& token);
  double accept(Points u);
  Points start_of_paths() const;
  Iteration record(const Points& before);
  Outcome end(Outcome outcome, std::string verdict);
  Outcome end_without_map(const Trial& trial, const std::string& where);

  MeshPair mesh_;
  Parameters parameters_;
  Constraints constraints_;
  ConformalSystem system_;
  InjectivityChecker checker_;
  std::string verdict_;
  std::vector<Complex> frames_;  ///< e^{iθ}, one a triangle of the system
  int programs_ = 0;
  int updates_ = 0;  ///< maps that were accepted
};

}  // namespace foldless
