// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace foldless {

/// The second-order cone Q = {s in R³ : s₀ ≥ ‖(s₁, s₂)‖}, its own dual, with the product
/// u ∘ v = (uᵀv, u₀v₁ + v₀u₁, u₀v₂ + v₀u₂) and the unit e = (1, 0, 0). On vectors (s₀, 0, 0)
/// everything here is what it is for the half-line s₀ ≥ 0.
using Cone3 = Eigen::Vector3d;

/// s₀ − ‖(s₁, s₂)‖, positive inside Q.
double depth(const Cone3& s);

/// u ∘ v.
Cone3 cone_product(const Cone3& u, const Cone3& v);
/// x with u ∘ x = v. Precondition: u inside Q.
Cone3 cone_quotient(const Cone3& u, const Cone3& v);

/// The largest t ≥ 0 for which s + t d stays in Q; infinite when nothing bounds it.
/// Precondition: s inside Q.
double largest_step(const Cone3& s, const Cone3& d);

/// The scaling of Nesterov and Todd for a point s and a dual point z inside Q: the symmetric W
/// with W z = W⁻¹ s = λ.
struct NesterovTodd {
  NesterovTodd() {}  ///< of nothing yet; a vector of defaulted ones would be cleared first
  NesterovTodd(const Cone3& s, const Cone3& z);

  Eigen::Matrix3d W;
  Eigen::Matrix3d W_inv;
  Eigen::Matrix3d W_inv2;
  Cone3 lambda;
};

}  // namespace foldless
