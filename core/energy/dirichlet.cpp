// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/dirichlet.h"

#include "core/energy/determinant.h"

namespace foldless {

double dirichlet_value(const Mat2& J) { return 0.5 * (J - Mat2::Identity()).squaredNorm(); }

DensityDerivatives dirichlet_derivatives(const Mat2& J) {
  return {dirichlet_value(J), vec(J - Mat2::Identity()), Eigen::Matrix4d::Identity()};
}

}  // namespace foldless
