// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/energy/density.h"

namespace foldless::test {

/// ∂ det J / ∂J.
inline Mat2 cofactors(const Mat2& J) { return eigen_of(foldless::cofactors(matrix2(J))); }

/// vec(J) = (J₀₀, J₁₀, J₀₁, J₁₁).
inline Eigen::Vector4d vec(const Mat2& J) { return J.reshaped(); }

/// ∂² det/∂ vec(J)².
inline Eigen::Matrix4d determinant_hessian() {
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  h(0, 3) = h(3, 0) = 1;
  h(1, 2) = h(2, 1) = -1;
  return h;
}

/// ∇ψ as the coefficients say.
inline Eigen::Vector4d dense_gradient(const DensityDerivatives& d, const Mat2& J) {
  return d.norm * vec(J) + d.det * vec(cofactors(J)) + d.trace * vec(Mat2::Identity());
}

/// ∇²ψ as the coefficients say.
inline Eigen::Matrix4d dense_hessian(const DensityDerivatives& d, const Mat2& J) {
  const Eigen::Vector4d j = vec(J), g = vec(cofactors(J));
  return d.norm * Eigen::Matrix4d::Identity() + d.det * determinant_hessian() +
         d.norm_norm * j * j.transpose() + d.norm_det * (j * g.transpose() + g * j.transpose()) +
         d.det_det * g * g.transpose();
}

}  // namespace foldless::test
