// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>

namespace foldless::test {

/// Derivative of a vector-valued function along each coordinate of x, one a column, by central
/// differences of sixth order with step h.
inline Eigen::MatrixXd finite_difference(
    const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& f, const Eigen::VectorXd& x,
    double h) {
  const Eigen::Index rows = f(x).size();
  Eigen::MatrixXd jacobian(rows, x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto at = [&](double offset) {
      Eigen::VectorXd moved = x;
      moved[i] += offset;
      return f(moved);
    };
    jacobian.col(i) =
        (45 * (at(h) - at(-h)) - 9 * (at(2 * h) - at(-2 * h)) + (at(3 * h) - at(-3 * h))) /
        (60 * h);
  }
  return jacobian;
}

/// ‖a − b‖ over ‖b‖.
inline double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).norm() / b.norm();
}

}  // namespace foldless::test
