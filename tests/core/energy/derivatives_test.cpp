// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/energy/barrier.h"
#include "core/energy/conformal_power.h"
#include "core/energy/densities.h"
#include "tests/support/dense_derivatives.h"
#include "tests/support/finite_difference.h"

namespace foldless {
namespace {

using test::vec;

constexpr double kTolerance = 1e-6;

Mat2 matrix_of(const Eigen::VectorXd& x) {
  Mat2 J;
  J << x[0], x[2], x[1], x[3];
  return J;
}

/// R(a) diag(σ₁, σ₂) R(b) with σ₂ down to `smallest`.
Mat2 random_gradient(std::mt19937_64& random, double smallest) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto rotation = [&] {
    const double angle = 6.283185307179586 * unit(random);
    Mat2 R;
    R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    return R;
  };
  const double sigma1 = std::exp(2 * unit(random) - 1);
  const double sigma2 = smallest * std::exp(unit(random));
  return rotation() * Vec2(sigma1, sigma2).asDiagonal() * rotation();
}

class DensityTest : public testing::TestWithParam<Density> {};

TEST_P(DensityTest, DerivativesAgreeWithFiniteDifferencesNearDegenerateToo) {
  const Density& density = GetParam();
  std::mt19937_64 random(7);
  for (const double smallest : {1.0, 0.3, 1e-2, 1e-4}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Mat2 J = random_gradient(random, smallest);
      SCOPED_TRACE(testing::Message() << "trial " << trial << ", smallest " << smallest);
      const DensityDerivatives d = density.derivatives(J);
      const Eigen::Vector4d expected_gradient = test::dense_gradient(d, J);
      const double h = 1e-2 * std::min(J.determinant() / J.norm(), 1.0);
      const Eigen::MatrixXd gradient = test::finite_difference(
          [&](const Eigen::VectorXd& x) {
            return Eigen::VectorXd::Constant(1, density.value(matrix_of(x)));
          },
          vec(J), h);
      const Eigen::MatrixXd hessian = test::finite_difference(
          [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return test::dense_gradient(density.derivatives(matrix_of(x)), matrix_of(x));
          },
          vec(J), h);
      EXPECT_NEAR(d.value, density.value(J), 1e-14 * d.value);
      // A gradient may vanish (a conformal J), so an absolute floor of the size of ψ's scale joins.
      const double scale = std::max(expected_gradient.norm(), 1e-3);
      EXPECT_LT((gradient.transpose() - expected_gradient).norm() / scale, kTolerance);
      EXPECT_LT(test::relative_difference(hessian, test::dense_hessian(d, J)), kTolerance);
    }
  }
}

TEST_P(DensityTest, RotatingTheTargetDoesNotChangeItUnlessItIsTheDirichletEnergy) {
  const Density& density = GetParam();
  if (density.name == "dirichlet") return;  // it measures the displacement
  std::mt19937_64 random(11);
  const Mat2 J = random_gradient(random, 0.4);
  Mat2 R;
  R << 0.6, -0.8, 0.8, 0.6;
  EXPECT_NEAR(density.value(R * J), density.value(J), 1e-12 * density.value(J));
}

TEST_P(DensityTest, TheIdentityIsAMinimum) {
  const Density& density = GetParam();
  const DensityDerivatives d = density.derivatives(Mat2::Identity());
  EXPECT_LT(test::dense_gradient(d, Mat2::Identity()).norm(), 1e-14);
  std::mt19937_64 random(13);
  for (int trial = 0; trial < 20; ++trial)
    EXPECT_GE(density.value(random_gradient(random, 0.5)), d.value);
}

INSTANTIATE_TEST_SUITE_P(Densities, DensityTest,
                         testing::ValuesIn(densities().begin(), densities().end()),
                         [](const auto& row) {
                           std::string name(row.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

template <int q>
Density conformal_power() {
  return {"conformal-power",
          "",
          "",
          0,
          false,
          {},
          [](const Mat2& J) { return conformal_power_value(J, q); },
          [](const Mat2& J) { return conformal_power_derivatives(J, q); }};
}

INSTANTIATE_TEST_SUITE_P(ConformalPowers, DensityTest,
                         testing::Values(conformal_power<2>(), conformal_power<4>(),
                                         conformal_power<16>()));

TEST(Densities, ClosedFormsMatchTheSingularValues) {
  Mat2 J;
  J << 1.3, 0.4, -0.2, 0.7;
  const Vec2 s = signed_singular_values(J);
  EXPECT_NEAR(find_density("lscm")->value(J), 0.5 * std::pow(s[0] - s[1], 2), 1e-14);
  EXPECT_NEAR(find_density("arap")->value(J), 0.5 * (std::pow(s[0] - 1, 2) + std::pow(s[1] - 1, 2)),
              1e-14);
  EXPECT_NEAR(find_density("green-strain")->value(J),
              std::pow(s[0] * s[0] - 1, 2) + std::pow(s[1] * s[1] - 1, 2), 1e-13);
  EXPECT_NEAR(find_density("symmetric-dirichlet")->value(J),
              0.5 * (s[0] * s[0] + s[1] * s[1] + std::pow(s[0], -2) + std::pow(s[1], -2)), 1e-13);
  const double k = 0.5 * (s[0] / s[1] + s[1] / s[0]);
  for (const int q : {2, 4, 8, 16})
    EXPECT_NEAR(conformal_power_value(J, q) / std::pow(k, q), 1, 1e-13) << q;
  EXPECT_EQ(find_density("arpa"), nullptr);
}

TEST(Barrier, DerivativesAgreeWithFiniteDifferencesUpToTheWall) {
  for (const double delta : {1e-5, 1e-3, 1e-1})
    for (const double x : {1e-6, 1e-4, 1e-2, 0.2, 0.7, 0.95}) {
      SCOPED_TRACE(testing::Message() << "delta " << delta << ", x " << x);
      const double det = delta + x * (1 - delta);
      const BarrierDerivatives<double> d = barrier_derivatives(det, delta);
      const double h = 1e-2 * std::min(x, 1 - x);
      const auto along = [&](auto f) {
        return test::finite_difference(
            [&](const Eigen::VectorXd& y) { return Eigen::VectorXd::Constant(1, f(y[0])); },
            Eigen::VectorXd::Constant(1, det), h)(0, 0);
      };
      EXPECT_NEAR(along([&](double y) { return barrier_value(y, delta); }) / d.first, 1,
                  kTolerance);
      EXPECT_NEAR(along([&](double y) { return barrier_derivatives(y, delta).first; }) / d.second,
                  1, kTolerance);
    }
}

TEST(Barrier, IsZeroBeyondTheRestAreaAndInfiniteAtTheBound) {
  EXPECT_EQ(barrier_value(1.0, 0.1), 0);
  EXPECT_EQ(barrier_value(3.0, 0.1), 0);
  EXPECT_TRUE(std::isinf(barrier_value(0.1, 0.1)));
  EXPECT_TRUE(std::isinf(barrier_value(-1.0, 0.1)));
  EXPECT_TRUE(std::isinf(barrier_value(std::nan(""), 0.1)));
}

TEST(Barrier, IsTwiceContinuouslyDifferentiableWhereItEnds) {
  const BarrierDerivatives<double> d = barrier_derivatives(1 - 1e-9, 1e-3);
  EXPECT_NEAR(d.value, 0, 1e-12);
  EXPECT_NEAR(d.first, 0, 1e-12);
  EXPECT_NEAR(d.second, 0, 1e-7);
}

}  // namespace
}  // namespace foldless
