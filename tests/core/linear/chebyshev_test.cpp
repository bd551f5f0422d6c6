// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/chebyshev.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/core/linear/elastic_grid.h"
#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

/// The 2 × 2 blocks on the diagonal.
Eigen::MatrixXd diagonal_blocks(const Eigen::MatrixXd& A) {
  Eigen::MatrixXd D = Eigen::MatrixXd::Zero(A.rows(), A.cols());
  for (Eigen::Index i = 0; i < A.rows(); i += 2) D.block<2, 2>(i, i) = A.block<2, 2>(i, i);
  return D;
}

Eigen::VectorXd smoothed(const ChebyshevSmoother& smoother, const Eigen::VectorXd& r) {
  Eigen::VectorXd x, image;
  smoother.smooth(r, x, image);
  return x;
}

Eigen::MatrixXd as_matrix(const ChebyshevSmoother& smoother, int size) {
  Eigen::MatrixXd matrix(size, size);
  for (int i = 0; i < size; ++i) matrix.col(i) = smoothed(smoother, Eigen::VectorXd::Unit(size, i));
  return matrix;
}

TEST(ChebyshevSmoother, IsSymmetricAndPositiveDefinite) {
  const SparseSymmetric A = test::elastic_grid(6);
  const Eigen::MatrixXd S = as_matrix(ChebyshevSmoother(A), A.size());
  EXPECT_LT((S - S.transpose()).norm(), 1e-12 * S.norm());
  EXPECT_GT(test::smallest_eigenvalue(S), 0);
}

// p of degree 2, 1 at 0 and equally large at 0.6, 1.5 and 2.4: 1 / T₂(5/3) = 9 / 41.
TEST(ChebyshevSmoother, LeavesOfAnErrorThePolynomialThatIsLeastOnTheUpperEigenvalues) {
  const SparseSymmetric A = test::elastic_grid(6);
  const Eigen::MatrixXd dense = test::dense(A);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(dense,
                                                                        diagonal_blocks(dense));
  const ChebyshevSmoother smoother(A);
  int upper = 0;
  for (Eigen::Index i = 0; i < A.size(); ++i) {
    const double value = eigen.eigenvalues()[i], x = (1.5 - value) / 0.9;
    EXPECT_LT(value, 3);
    const Eigen::VectorXd error = eigen.eigenvectors().col(i);
    const Eigen::VectorXd left = error - smoothed(smoother, dense * error);
    EXPECT_LT((left - (2 * x * x - 1) * 9 / 41 * error).norm(), 1e-9 * error.norm());
    EXPECT_LT(left.norm(), error.norm());
    if (value < 0.6 || value > 2.4) continue;
    EXPECT_LE(left.norm(), (9 / 41.0 + 1e-9) * error.norm());
    ++upper;
  }
  EXPECT_GT(upper, A.size() / 4);
}

TEST(ChebyshevSmoother, SeesThatABlockIsNotPositiveDefinite) {
  SparseSymmetric A = test::elastic_grid(3);
  EXPECT_TRUE(ChebyshevSmoother(A).is_definite());
  add_block(A, 5, 5, Eigen::Matrix2d{{0, 0}, {100, 0}});
  EXPECT_FALSE(ChebyshevSmoother(A).is_definite());
  A = test::elastic_grid(3);
  add_block(A, 5, 5, -100 * Eigen::Matrix2d::Identity());  // its determinant is positive
  EXPECT_FALSE(ChebyshevSmoother(A).is_definite());
}

}  // namespace
}  // namespace foldless
