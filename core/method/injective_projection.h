// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/method/conformal_system.h"
#include "core/method/stepped_method.h"

namespace foldless {

/// Injective and bounded distortion mappings [AL13], its 2D form: one quadratic program a step.
/// From the energy's minimiser with the handles at their targets, which may fold, each step goes to
/// the map nearest to the one before, Σ A‖J(u) − J(u_n)‖², subject to Cu = p and, on every
/// triangle, Re(e^{−i arg f_z̄} f_z̄) ≤ k Re(e^{−i arg f_z} f_z): the half-plane that supports
/// {σ₁/σ₂ ≤ K, det J ≥ 0} at its point nearest to J(u_n).
///
/// Its maps are folded until it has converged, if it does, and then may wind twice round interior
/// vertices. The problem's rest mesh has a bounding-box diagonal of about 1.
class InjectiveProjection final : public SteppedMethod {
 public:
  /// Throws Error when the energy is none of dirichlet, lscm and arap, or cannot hold a part of
  /// the mesh.
  explicit InjectiveProjection(const Problem& problem);

  std::string verdict() const override { return verdict_; }
  const MeshPair& mesh() const override { return mesh_; }
  void set_targets(const Points& targets) override;

 private:
  StageTimes stage_times() const override { return system_.solver.times(); }

  /// A map that is asked of a program.
  struct Trial {
    ConeStatus status = ConeStatus::cancelled;
    Points u;
    friend bool is_cancelled(const Trial& trial) { return trial.status == ConeStatus::cancelled; }
  };

  Steps<Outcome> solve();
  Trial unconstrained_minimum(const std::stop_token& token);
  Trial project(const std::stop_token& token);
  TriangleTerm half_plane(const ConformalParts& now) const;
  std::optional<Outcome> judge(double step_squared, int programs);
  Iteration record(const Points& before, int programs) const;
  Outcome end(Outcome outcome, std::string verdict);

  MeshPair mesh_;
  Parameters parameters_;
  Constraints constraints_;
  ConformalSystem system_;
  InjectivityChecker checker_;
  std::string verdict_;
  int updates_ = 0;
};

}  // namespace foldless
