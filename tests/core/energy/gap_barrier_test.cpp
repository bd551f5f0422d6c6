// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/gap_barrier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/dense_matrix.h"
#include "tests/support/finite_difference.h"

namespace foldless {
namespace {

using std::numbers::pi;

/// Vertex 0 between its neighbours 1, next, and 2, previous, with a gap of `angle`.
struct OneGap {
  OneGap(double angle, std::mt19937& random) : u(2, 3) {
    std::uniform_real_distribution<double> unit(0.1, 1);
    const double previous = 7 * unit(random), next = previous + angle;
    u.col(0) = Vec2(unit(random), unit(random));
    u.col(1) = u.col(0) + unit(random) * Vec2(std::cos(next), std::sin(next));
    u.col(2) = u.col(0) + unit(random) * Vec2(std::cos(previous), std::sin(previous));
  }
  double value_at(const Eigen::VectorXd& x) const {
    return gap_barrier_value(gap, x.reshaped(2, 3));
  }
  Eigen::VectorXd gradient_at(const Eigen::VectorXd& x) const {
    const GapBarrier b = gap_barrier(gap, x.reshaped(2, 3));
    Eigen::VectorXd gradient(6);
    gradient << -(b.by_next + b.by_previous), b.by_next, b.by_previous;
    return gradient;
  }
  Eigen::MatrixXd hessian() const {
    const GapBarrier b = gap_barrier(gap, u);
    const Mat2 &n = b.next_curvature, &p = b.previous_curvature, none = Mat2::Zero();
    Eigen::MatrixXd hessian(6, 6);
    hessian << n + p, -n, -p,  //
        -n, n, none,           //
        -p, none, p;
    return hessian;
  }

  BoundaryGap gap{0, {1, 2}, 0.9, 0.3};
  Points u;
};

TEST(GapBarrier, IsThatOfTheAngleOutsideOfTheMesh) {
  std::mt19937 random(1);
  for (const double x : {1e-6, 0.01, 0.3, 0.9, 0.9999}) {
    const OneGap one(0.9 * x, random);
    const double b = -(1 - x) * (1 - x) * std::log(x);
    EXPECT_NEAR(gap_barrier_value(one.gap, one.u), 0.3 * b, 1e-9 * b);
    EXPECT_EQ(gap_barrier(one.gap, one.u).value, gap_barrier_value(one.gap, one.u));
  }
}

TEST(GapBarrier, IsNothingInAWideGapHoweverWide) {
  std::mt19937 random(1);
  for (double angle = 0.91; angle < 2 * pi; angle += 0.1) {
    const OneGap one(angle, random);
    EXPECT_EQ(gap_barrier_value(one.gap, one.u), 0) << angle;
    EXPECT_EQ(one.gradient_at(one.u.reshaped()).norm(), 0) << angle;
  }
}

TEST(GapBarrier, IsInfiniteInAClosedGap) {
  std::mt19937 random(1);
  OneGap one(0, random);
  one.u << 0, 1, 2,  //
      0, 1, 2;
  EXPECT_TRUE(std::isinf(gap_barrier_value(one.gap, one.u)));
  EXPECT_TRUE(std::isinf(gap_barrier(one.gap, one.u).value));
}

TEST(GapBarrier, GradientAgreesWithFiniteDifferences) {
  const unsigned seed = 2;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  for (int i = 0; i < 200; ++i) {
    const OneGap one(0.9 * unit(random), random);
    const Eigen::VectorXd x = one.u.reshaped();
    const Eigen::MatrixXd numeric = test::finite_difference(
        [&](const Eigen::VectorXd& y) { return Eigen::VectorXd::Constant(1, one.value_at(y)); }, x,
        1e-5);
    EXPECT_LT(test::relative_difference(numeric.transpose(), one.gradient_at(x)), 1e-6);
  }
}

TEST(GapBarrier, HessianIsPositiveSemidefiniteAndNotLessThanFiniteDifferences) {
  const unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  for (int i = 0; i < 200; ++i) {
    const OneGap one(0.9 * unit(random), random);
    const Eigen::MatrixXd numeric = test::finite_difference(
        [&](const Eigen::VectorXd& y) { return one.gradient_at(y); }, one.u.reshaped(), 1e-5);
    const Eigen::MatrixXd hessian = one.hessian();
    EXPECT_GT(test::smallest_eigenvalue(hessian), -1e-10 * hessian.norm());
    EXPECT_GT(test::smallest_eigenvalue(hessian - numeric), -1e-6 * hessian.norm());
    // Nor is it more than the bound on the square makes it.
    EXPECT_LT(hessian.norm(), 4 * numeric.norm());
  }
}

}  // namespace
}  // namespace foldless
