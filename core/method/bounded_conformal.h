// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/method/conformal_system.h"
#include "core/method/handle_path.h"

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
class BoundedConformal final : public Method {
 public:
  /// Throws Error when the energy is none of dirichlet, lscm and arap, or cannot hold a part of
  /// the mesh.
  explicit BoundedConformal(Problem problem);

  std::unique_ptr<Method> clone() const override;
  std::optional<Iteration> step(std::stop_token token) override;
  std::optional<Outcome> outcome() const override { return outcome_; }
  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;
  StageTimes times() const override { return system_.solver.times(); }

 private:
  enum class Stage {
    first,      ///< the first program of given frames
    moving,     ///< the handles are on their way
    improving,  ///< at the targets, the frames follow the map
  };
  /// One program's end: a map, or why there is none.
  struct Attempt {
    ConeStatus status = ConeStatus::cancelled;
    Points u;
    std::string why;
  };

  void begin();
  void begin_path(HandlePath path);
  bool find_first_frames(const std::stop_token& token);
  Attempt attempt(const Points& handle_positions, double tolerance, const std::stop_token& token);
  void take_first(Attempt attempt);
  void take_move(double lambda, Attempt attempt);
  void take_improvement(Attempt attempt);
  void give_up_path(const Attempt& attempt);
  double take(Points u);
  void end(Outcome outcome, std::string verdict);
  void end_without_map(const Attempt& attempt, const std::string& where);
  Points handle_start() const;

  MeshPair mesh_;
  Parameters parameters_;
  Positions positions_;
  ConformalSystem system_;
  InjectivityChecker checker_;

  std::optional<Outcome> outcome_;
  std::string verdict_;
  Stage stage_ = Stage::first;
  std::vector<Complex> frames_;  ///< e^{iθ}, one a triangle of the system
  double energy_ = 0;            ///< of mesh_, when improving
  int improvements_ = 0;
  int programs_ = 0;
  int updates_ = 0;  ///< maps that were taken
  double seconds_ = 0;

  // Of the continuation.
  Points start_;  ///< the map that every path begins with
  HandlePath path_;
  bool is_second_path_ = false;
  double lambda_ = 0;
  double lambda_step_ = 0;
  double farthest_lambda_ = 0;  ///< of the path before this one
  Points farthest_;             ///< its map there
};

}  // namespace foldless
