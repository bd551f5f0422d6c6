// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/conformal_square.h"

#include "core/energy/determinant.h"

namespace foldless {

double conformal_square_value(const Mat2& J) {
  const double k = J.squaredNorm() / (2 * determinant(J));
  return k * k;
}

DensityDerivatives conformal_square_derivatives(const Mat2& J) {
  const Eigen::Vector4d j = vec(J);
  const Eigen::Vector4d g = determinant_gradient(J);
  const double d = 1 / determinant(J);
  const double k = 0.5 * j.squaredNorm() * d;
  const Eigen::Vector4d first = d * (j - k * g);
  const Eigen::Matrix4d second = d * (Eigen::Matrix4d::Identity() - g * first.transpose() -
                                      first * g.transpose() - k * determinant_hessian());
  return {k * k, 2 * k * first, 2 * (k * second + first * first.transpose())};
}

}  // namespace foldless
