// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/clamp.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "core/energy/barrier.h"
#include "core/energy/conformal_power.h"
#include "core/energy/densities.h"
#include "tests/support/dense_derivatives.h"

namespace foldless {
namespace {

/// The nearest positive semidefinite matrix by a full eigendecomposition.
Eigen::Matrix4d clamped_by_eigenvalues(const Eigen::Matrix4d& hessian) {
  // Of any size, as other tests have it: its code is a tenth of their program.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(hessian);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

Mat2 random_gradient(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Mat2 J;
  do {
    J << unit(random), unit(random), unit(random), unit(random);
  } while (J.determinant() < 1e-2);
  return J;
}

/// ∇²ψ without the part `part` of its negative curvature.
Eigen::Matrix4d clamped_hessian(const DensityDerivatives& d, const Mat2& J, double part = 1) {
  Eigen::Matrix4d result = test::dense_hessian(d, J);
  const Curvature<double> curvature(d, matrix2(J));
  if (curvature.is_positive()) return result;
  const NegativeCurvature<double> c = curvature.negative_part();
  Mat2 turn;
  turn << 0, -1, 1, 0;
  const Eigen::Vector4d r = test::vec(eigen_of(c.rotation)), e = test::vec(eigen_of(c.reflection));
  const Eigen::Vector4d twist = test::vec(turn * eigen_of(c.rotation));
  const Eigen::Vector4d flip = test::vec(turn * eigen_of(c.reflection));
  result += part * (c.of_rotation * r * r.transpose() + c.of_reflection * e * e.transpose() +
                    c.of_both * (r * e.transpose() + e * r.transpose()) +
                    c.of_twist * twist * twist.transpose() + c.of_flip * flip * flip.transpose());
  return result;
}

void add(const DensityDerivatives& more, DensityDerivatives& sum) {
  sum.norm += more.norm;
  sum.det += more.det;
  sum.norm_norm += more.norm_norm;
  sum.norm_det += more.norm_det;
  sum.det_det += more.det_det;
}

TEST(NegativeCurvature, GivesTheNearestPositiveSemidefiniteMatrixForEveryDensityWithBarrier) {
  std::mt19937_64 random(11);
  int clamped = 0;
  for (const Density& density : densities())
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(testing::Message() << density.name << ", trial " << trial);
      const Mat2 J = random_gradient(random);
      DensityDerivatives d = density.derivatives(J);
      const BarrierDerivatives<double> chi = barrier_derivatives(J.determinant(), 1e-5);
      d.det += chi.first;
      d.det_det += chi.second;
      if (trial % 2 == 1) add(conformal_power_derivatives(J, trial % 4 == 1 ? 2 : 16), d);
      const Eigen::Matrix4d hessian = test::dense_hessian(d, J);
      const Eigen::Matrix4d expected = clamped_by_eigenvalues(hessian);
      EXPECT_LE((clamped_hessian(d, J) - expected).norm(), 1e-9 * hessian.norm());
      clamped += (expected - hessian).norm() > 1e-6 * hessian.norm();
    }
  EXPECT_GT(clamped, 100) << "the claim would be empty";
}

TEST(NegativeCurvature, IsTakenAwayInPart) {
  std::mt19937_64 random(12);
  for (const double part : {0.0, 0.25, 0.5, 1.0}) {
    const Mat2 J = random_gradient(random);
    const DensityDerivatives d{.norm = -0.3, .det_det = 2};
    const Eigen::Matrix4d hessian = test::dense_hessian(d, J);
    const Eigen::Matrix4d expected = hessian + part * (clamped_by_eigenvalues(hessian) - hessian);
    EXPECT_LE((clamped_hessian(d, J, part) - expected).norm(), 1e-12) << part;
  }
}

TEST(NegativeCurvature, IsExactWhereTheSingularValuesAreEqualAndWhereJIsDiagonal) {
  for (const Vec2& scales : {Vec2(1, 1), Vec2(0.1, 3), Vec2(3, 0.1), Vec2(0.3, 0.3)})
    for (const double angle : {0.0, 1.0, 3.1415, -2.0}) {
      const Mat2 J = Eigen::Rotation2Dd(angle) * Mat2(scales.asDiagonal());
      DensityDerivatives d = find_density("green-strain")->derivatives(J);
      d.det += 0.5;
      const Eigen::Matrix4d hessian = test::dense_hessian(d, J);
      EXPECT_LE((clamped_hessian(d, J) - clamped_by_eigenvalues(hessian)).norm(),
                1e-9 * hessian.norm())
          << scales.transpose() << ", " << angle;
    }
}

TEST(NegativeCurvature, IsNothingWhereTheHessianIsPositiveDefinite) {
  const Mat2 J = Mat2::Identity();
  const DensityDerivatives d = find_density("symmetric-dirichlet")->derivatives(J);
  EXPECT_TRUE(Curvature<double>(d, matrix2(J)).is_positive());
}

}  // namespace
}  // namespace foldless
