// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/arap.h"

#include <cmath>

#include "core/energy/determinant.h"

namespace foldless {

// With p = J₀₀ + J₁₁ and q = J₁₀ − J₀₁ the signed singular values add up to r = √(p² + q²), the
// closest rotation is [p −q; q p]/r, and ½‖J − R‖² = ½‖J‖² − r + 1.

double arap_value(const Mat2& J) {
  const double p = J(0, 0) + J(1, 1);
  const double q = J(1, 0) - J(0, 1);
  const double r = std::sqrt(p * p + q * q);
  Mat2 R;
  R << p / r, -q / r, q / r, p / r;
  return 0.5 * (J - R).squaredNorm();
}

DensityDerivatives arap_derivatives(const Mat2& J) {
  const double p = J(0, 0) + J(1, 1);
  const double q = J(1, 0) - J(0, 1);
  const double r = std::sqrt(p * p + q * q);
  const Eigen::Vector4d r_gradient = Eigen::Vector4d(p, q, -q, p) / r;
  // ∇²r = (e_p e_pᵀ + e_q e_qᵀ − ∇r ∇rᵀ)/r = n nᵀ/r with n ⊥ ∇r in the span of e_p and e_q.
  const Eigen::Vector4d normal = Eigen::Vector4d(-q, p, -p, -q) / r;
  return {arap_value(J), vec(J) - r_gradient,
          Eigen::Matrix4d::Identity() - normal * normal.transpose() / r};
}

}  // namespace foldless
