// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/clamp.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "core/energy/barrier.h"
#include "core/energy/conformal_square.h"
#include "core/energy/densities.h"
#include "core/energy/determinant.h"

namespace foldless {
namespace {

/// The nearest positive semidefinite matrix by a full eigendecomposition.
Eigen::Matrix4d clamped_by_eigenvalues(const Eigen::Matrix4d& hessian) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(hessian);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
         solver.eigenvectors().transpose();
}

Mat2 random_gradient(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Mat2 J;
  do {
    J << unit(random), unit(random), unit(random), unit(random);
  } while (determinant(J) < 1e-2);
  return J;
}

TEST(ClampedHessian, IsTheNearestPositiveSemidefiniteMatrixForEveryDensityWithBarrier) {
  std::mt19937_64 random(11);
  int clamped = 0;
  for (const Density& density : densities())
    for (int trial = 0; trial < 200; ++trial) {
      SCOPED_TRACE(testing::Message() << density.name << ", trial " << trial);
      const Mat2 J = random_gradient(random);
      const BarrierDerivatives chi = barrier_derivatives(determinant(J), 1e-5);
      const Eigen::Vector4d g = determinant_gradient(J);
      const Eigen::Matrix4d hessian =
          density.derivatives(J).hessian + chi.second * g * g.transpose() +
          chi.first * determinant_hessian() + trial % 2 * conformal_square_derivatives(J).hessian;
      const Eigen::Matrix4d expected = clamped_by_eigenvalues(hessian);
      EXPECT_LE((clamped_hessian(hessian, J) - expected).norm(), 1e-9 * hessian.norm());
      clamped += (expected - hessian).norm() > 1e-6 * hessian.norm();
    }
  EXPECT_GT(clamped, 100) << "the claim would be empty";
}

TEST(ClampedHessian, TakesTheWantedPartOfTheNegativeCurvatureAway) {
  std::mt19937_64 random(12);
  for (const double part : {0.0, 0.25, 0.5, 1.0}) {
    const Mat2 J = random_gradient(random);
    const Eigen::Matrix4d hessian =
        -0.3 * Eigen::Matrix4d::Identity() +
        2 * determinant_gradient(J) * determinant_gradient(J).transpose();
    const Eigen::Matrix4d expected = hessian + part * (clamped_by_eigenvalues(hessian) - hessian);
    EXPECT_LE((clamped_hessian(hessian, J, part) - expected).norm(), 1e-12) << part;
  }
}

TEST(ClampedHessian, IsExactWhereTheSingularValuesAreEqualAndWhereJIsDiagonal) {
  for (const Vec2& scales : {Vec2(1, 1), Vec2(0.1, 3), Vec2(3, 0.1)})
    for (const double angle : {0.0, 1.0, 3.1415, -2.0}) {
      const Mat2 J = Eigen::Rotation2Dd(angle) * Mat2(scales.asDiagonal());
      const Eigen::Matrix4d hessian =
          find_density("green-strain")->derivatives(J).hessian + 0.5 * determinant_hessian();
      EXPECT_LE((clamped_hessian(hessian, J) - clamped_by_eigenvalues(hessian)).norm(),
                1e-9 * hessian.norm())
          << scales.transpose() << ", " << angle;
    }
}

TEST(ClampedHessian, LeavesAPositiveDefiniteHessianAsItIs) {
  const Mat2 J = Mat2::Identity();
  const Eigen::Matrix4d hessian = find_density("symmetric-dirichlet")->derivatives(J).hessian;
  EXPECT_LE((clamped_hessian(hessian, J) - hessian).norm(), 1e-12);
}

}  // namespace
}  // namespace foldless
