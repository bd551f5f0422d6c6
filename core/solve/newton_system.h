// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/energy/objective.h"
#include "core/solve/effort.h"
#include "core/solve/hessian_factor.h"

namespace foldless {

/// The linear system of eq. 6 for one mesh: E, ∇E and ∇²E as they were assembled last, and the
/// factor of that ∇²E or of an earlier one. It never keeps which energy is minimised: that comes
/// with every call. What is done with it is in newton_step.h. Copyable; a copy adds to the same
/// effort.
class NewtonSystem {
 public:
  /// `constraints` tells which vertices have hard handles. `effort` outlives the system.
  NewtonSystem(const MeshPair& mesh, const Constraints& constraints, Effort& effort);

  /// Follows a changed connectivity with the same hard handles.
  void rebuild(const MeshPair& mesh, const Constraints& constraints);
  /// The same where edges were flipped and nothing else.
  void follow_flips(const MeshPair& mesh);

  const Objective& objective() const { return objective_; }
  Effort& effort() const { return *effort_; }

  /// Assembles E, ∇E and ∇²E at u for the factorizations that follow; elements are without the
  /// part `clamping` of their negative curvature.
  void assemble(const Energy& energy, const Points& u, double clamping = 0);
  /// Assembles E and ∇E alone. ∇²E and its factor stay good when only targets moved since
  /// assemble().
  void assemble_gradient(const Energy& energy, const Points& u);
  const EnergyTerms& energy() const { return first_order_.energy; }
  const Eigen::VectorXd& gradient() const { return first_order_.gradient; }
  const Hessian& hessian() const { return hessian_; }
  /// ∇²E as assembled last; the next time it is assembled anew.
  Hessian take_hessian();

  /// Tell it when the vertices moved: HessianFactor::outdate().
  HessianFactor& factor() { return factor_; }
  /// How the vertices followed when handles were carried, 2 #V each, the last time first. Not of
  /// more than three times, in which a handle went all ways there are, and bent a little.
  const std::vector<Eigen::VectorXd>& followings() const { return followings_; }
  void has_followed(Eigen::VectorXd following);

 private:
  void outdate_pattern();

  Effort* effort_;
  Objective objective_;
  Hessian hessian_;
  bool has_pattern_ = false;  ///< hessian_ has that of the connectivity as it is
  EnergyGradient first_order_;
  HessianFactor factor_;
  std::vector<Eigen::VectorXd> followings_;
};

}  // namespace foldless
