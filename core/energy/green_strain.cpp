// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/green_strain.h"

#include "core/energy/determinant.h"

namespace foldless {

double green_strain_value(const Mat2& J) {
  return (J.transpose() * J - Mat2::Identity()).squaredNorm();
}

DensityDerivatives green_strain_derivatives(const Mat2& J) {
  // With n = ‖J‖²: ‖JᵀJ‖² = n² − 2 det², so ψ = n² − 2 det² − 2n + 2.
  const Eigen::Vector4d j = vec(J);
  const Eigen::Vector4d g = determinant_gradient(J);
  const double n = j.squaredNorm();
  const double det = determinant(J);
  return {green_strain_value(J), 4 * (n - 1) * j - 4 * det * g,
          8 * j * j.transpose() + 4 * (n - 1) * Eigen::Matrix4d::Identity() -
              4 * g * g.transpose() - 4 * det * determinant_hessian()};
}

}  // namespace foldless
