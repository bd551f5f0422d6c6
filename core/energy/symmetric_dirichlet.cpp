// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/symmetric_dirichlet.h"

#include "core/energy/determinant.h"

namespace foldless {

// ‖J⁻¹‖² = ‖J‖²/det² in two dimensions, so ψ = ½ n (1 + det⁻²) with n = ‖J‖².

double symmetric_dirichlet_value(const Mat2& J) {
  const double det = determinant(J);
  return 0.5 * J.squaredNorm() * (1 + 1 / (det * det));
}

DensityDerivatives symmetric_dirichlet_derivatives(const Mat2& J) {
  const Eigen::Vector4d j = vec(J);
  const Eigen::Vector4d g = determinant_gradient(J);
  const double n = j.squaredNorm();
  const double det = determinant(J);
  const double det2 = 1 / (det * det);
  const double det3 = det2 / det;
  const double det4 = det2 * det2;
  return {symmetric_dirichlet_value(J), (1 + det2) * j - n * det3 * g,
          (1 + det2) * Eigen::Matrix4d::Identity() -
              2 * det3 * (j * g.transpose() + g * j.transpose()) +
              3 * n * det4 * g * g.transpose() - n * det3 * determinant_hessian()};
}

}  // namespace foldless
