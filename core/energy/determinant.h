// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/mesh/triangle.h"

namespace foldless {

/// vec(J) = (J₀₀, J₁₀, J₀₁, J₁₁): the order of every derivative with respect to J.
inline Eigen::Vector4d vec(const Mat2& J) { return {J(0, 0), J(1, 0), J(0, 1), J(1, 1)}; }

/// det J = A′/A.
inline double determinant(const Mat2& J) { return J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0); }

/// ∂ det J / ∂ vec(J).
inline Eigen::Vector4d determinant_gradient(const Mat2& J) {
  return {J(1, 1), -J(0, 1), -J(1, 0), J(0, 0)};
}

/// ∂² det J / ∂ vec(J)², a constant.
inline Eigen::Matrix4d determinant_hessian() {
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  h(0, 3) = h(3, 0) = 1;
  h(1, 2) = h(2, 1) = -1;
  return h;
}

}  // namespace foldless
