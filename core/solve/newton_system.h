// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stop_token>

#include "core/energy/objective.h"
#include "core/solve/effort.h"
#include "core/solve/hessian_factor.h"

namespace foldless {

/// A step from the factor of an earlier ∇²E.
struct LaggedStep {
  Points step;                 ///< displacements of the vertices, 2 × #V
  bool is_indefinite = false;  ///< no step: ∇²E turned out not to be positive definite
};

/// The linear system of eq. 6 for one mesh, with the damping of [SKPSH13] that lives from one
/// iteration to the next. It keeps what was assembled and factorized, never which energy is
/// minimised: that comes with every call. Copyable; a copy adds to the same effort.
class NewtonSystem {
 public:
  /// `constraints` tells which vertices have hard handles. `effort` outlives the system.
  NewtonSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort);

  /// Follows a changed connectivity with the same hard handles.
  void rebuild(const MeshPair& mesh, const Constraints& constraints, int changed_edges);
  /// The same where `flips` edges were flipped and nothing else.
  void follow_flips(const MeshPair& mesh, int flips);

  const Objective& objective() const { return objective_; }
  Effort& effort() const { return *effort_; }

  /// Assembles E, ∇E and ∇²E at u for the factorizations that follow; elements are without the
  /// part `clamping` of their negative curvature.
  void assemble(const Energy& energy, const Points& u, double clamping = 0);
  /// Assembles E and ∇E alone. ∇²E and its factor stay good when only targets moved since
  /// assemble().
  void assemble_gradient(const Energy& energy, const Points& u);
  /// E and ∇E as assembled last.
  const EnergyTerms& energy() const { return first_order_.energy; }
  const Eigen::VectorXd& gradient() const { return first_order_.gradient; }
  /// True when the factor of ∇²E itself, as last assembled, is at hand.
  bool has_plain_factor() const { return factor_.is_exact(); }
  /// Orders the unknowns for the pattern as last assembled, where that is not done: what comes
  /// before a factorization, so that a cancellation need not wait for both.
  void analyze();
  /// Factorizes ∇²E + μI as last assembled; false when it is not positive definite. Counts H.
  bool factorize(double mu);
  /// True when ∇²E itself is positive definite; its factor then serves the next solve.
  bool factorize_plain();
  /// Factorizes ∇²E + μI for the smallest μ that the damping tries: μ = 0 first unless
  /// `plain_failed` (the caller knows), then λ added cumulatively, ×10 a failure. Nothing when
  /// cancelled or when λ ran out of range, from where it begins anew; else μ.
  std::optional<double> factorize_damped(bool plain_failed, const std::stop_token& token);
  /// −(factor)⁻¹ ∇E as displacements of the vertices, 2 × #V.
  Points newton_step();
  /// The same where the held handles move by `way`, 2 × #V and zero elsewhere, and the others
  /// follow it: −(factor)⁻¹ (∇E + ∇²E way) with the handles' part of ∇²E at `u`, clamped, and `way`
  /// itself at the handles.
  Points carrying_step(const EnergySettings& settings, const Points& u, const Points& way);
  /// newton_step() without a factorization of ∇²E as last assembled: by conjugate gradients from
  /// the factor of an earlier one, where there is one that is near enough: of the same energy but
  /// for α and the conformal weight, with the same handles held.
  std::optional<LaggedStep> lagged_newton_step();
  /// carrying_step() in that way.
  std::optional<LaggedStep> lagged_carrying_step(const EnergySettings& settings, const Points& u,
                                                 const Points& way);
  /// ∇E · step.
  double slope(const Points& step) const;
  /// Says that the vertices moved: what was assembled and factorized is out of date.
  void moved() { factor_.outdate(); }
  /// Says that ∇²E changed too much for its factor to serve another step.
  void outdate_factor() { factor_.set_far(); }

 private:
  void outdate_pattern(const MeshPair& mesh, int changed_edges);
  std::optional<LaggedStep> lagged_step(const Eigen::VectorXd& right_hand_side, double least_gain);

  Effort* effort_;
  Objective objective_;
  Hessian hessian_;
  bool has_pattern_ = false;  ///< hessian_ has that of the connectivity as it is
  EnergyGradient first_order_;
  HessianFactor factor_;
  double lambda_;
};

}  // namespace foldless
