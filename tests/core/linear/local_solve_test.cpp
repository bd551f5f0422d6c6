// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/local_solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/linear/conjugate_gradients.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/core/linear/random_values.h"
#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

constexpr int kSquares = 12;  ///< of a side of the grid

/// Some beside each other, one at the held side, one at a corner.
const std::vector<int> kNodes{0, 40, 41, 53, 54, 55, 67, 120, 168};

bool is_local(Eigen::Index unknown) {
  return std::binary_search(kNodes.begin(), kNodes.end(), static_cast<int>(unknown / 2));
}

void expect_zero_at_nodes(const Eigen::VectorXd& values) {
  for (const int node : kNodes) EXPECT_LT(values.segment<2>(2 * node).norm(), 1e-11) << node;
}

void expect_as_before_elsewhere(const Eigen::VectorXd& x, const Eigen::VectorXd& before) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (is_local(i)) continue;
    EXPECT_EQ(x[i], before[i]) << i;
  }
}

/// The grid after its stiffness at kNodes was changed, one by one, by up to `most`, and blocks of
/// them and others beside them, which were symmetric.
SparseSymmetric changed_grid(double most) {
  SparseSymmetric A = test::elastic_grid(kSquares);
  double stiffness = most;
  for (const int node : kNodes) {
    add_block(A, node, node, stiffness * Eigen::Matrix2d{{1, 0.5}, {0.5, 1}});
    stiffness /= 2;
  }
  for (const auto& [i, j] : {std::pair(40, 39), std::pair(41, 40), std::pair(42, 41)})
    add_block(A, i, j, Eigen::Matrix2d{{0, 0.2}, {-0.1, 0}});
  return A;
}

Eigen::VectorXd product(const SparseSymmetric& A, const Eigen::VectorXd& x) {
  return test::dense(A) * x;
}

TEST(LocalSolve, MakesTheResidualZeroAtItsNodesAndMovesThemAlone) {
  const SparseSymmetric A = changed_grid(50);
  LocalSolve local(A, kNodes);
  ASSERT_TRUE(local.is_definite());
  const Eigen::VectorXd b = test::random_values(A.size(), 1);
  const Eigen::VectorXd before = test::random_values(A.size(), 2);
  const auto model = [&](const Eigen::VectorXd& x) {
    return 0.5 * x.dot(product(A, x)) - b.dot(x);
  };
  Eigen::VectorXd x = before, r = b - product(A, x);
  const double fall = local.correct(x, r);
  EXPECT_LT((r - (b - product(A, x))).norm(), 1e-10 * b.norm());
  EXPECT_NEAR(fall, model(before) - model(x), 1e-9 * fall);
  expect_zero_at_nodes(r);
  expect_as_before_elsewhere(x, before);
}

TEST(LocalSolve, MakesAVectorConjugateToWhatItsNodesCanDo) {
  const SparseSymmetric A = changed_grid(50);
  LocalSolve local(A, kNodes);
  const Eigen::VectorXd before = test::random_values(A.size(), 3);
  Eigen::VectorXd x = before;
  local.make_conjugate(x);
  expect_zero_at_nodes(product(A, x));
  expect_as_before_elsewhere(x, before);
}

TEST(LocalSolve, SeesAMatrixThatIsNotDefiniteThere) {
  EXPECT_FALSE(LocalSolve(changed_grid(-50), kNodes).is_definite());
  EXPECT_TRUE(LocalSolve(changed_grid(-50), {70, 71}).is_definite()) << "it looks no further";
}

TEST(LocalSolve, SavesTheIterationsThatItsNodesWouldTake) {
  const SparseSymmetric A = changed_grid(1e4);
  Cholesky factor;
  factor.analyze(A);
  ASSERT_TRUE(factor.factorize(test::elastic_grid(kSquares)));
  const Eigen::VectorXd b = test::random_values(A.size(), 4);
  LocalSolve local(A, kNodes);
  ConjugateGradientSettings settings{.least_gain = 1e-10, .most_iterations = 100};
  const ConjugateGradientSolution without = conjugate_gradients(A, b, factor, settings);
  settings.local = &local;
  const ConjugateGradientSolution with = conjugate_gradients(A, b, factor, settings);
  EXPECT_LT(with.iterations, without.iterations / 2);
  const Eigen::VectorXd exact = test::dense(A).ldlt().solve(b);
  EXPECT_LT((with.x - exact).norm(), 1e-6 * exact.norm());
}

TEST(LocalSolve, GoesOnFromTheBestGuess) {
  const SparseSymmetric A = changed_grid(1e4);
  Cholesky factor;
  factor.analyze(A);
  ASSERT_TRUE(factor.factorize(test::elastic_grid(kSquares)));
  const Eigen::VectorXd b = test::random_values(A.size(), 4);
  const Eigen::VectorXd exact = test::dense(A).ldlt().solve(b);
  LocalSolve local(A, kNodes);
  const std::vector<Eigen::VectorXd> guesses{exact + 1e-3 * test::random_values(A.size(), 5)};
  const ConjugateGradientSettings settings{
      .least_gain = 1e-10, .most_iterations = 100, .guesses = guesses, .local = &local};
  const ConjugateGradientSolution found = conjugate_gradients(A, b, factor, settings);
  EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
  EXPECT_LT((found.x - exact).norm(), 1e-5 * exact.norm());
}

TEST(LocalSolve, TakesInTheNodesBesideThose) {
  constexpr int kRow = kSquares + 1;
  const SparseSymmetric A = test::elastic_grid(kSquares);
  // Diagonals go from the right down to the left up.
  EXPECT_EQ(with_neighbours(A, {0}), (std::vector{0, 1, kRow}));
  const int middle = 5 * kRow + 5;
  EXPECT_EQ(with_neighbours(A, {middle}),
            (std::vector{middle - kRow, middle - kRow + 1, middle - 1, middle, middle + 1,
                         middle + kRow - 1, middle + kRow}));
}

}  // namespace
}  // namespace foldless
