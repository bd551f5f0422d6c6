// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/multigrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

#include "core/linear/conjugate_gradients.h"
#include "core/threads/team.h"
#include "tests/core/linear/elastic_grid.h"
#include "tests/core/linear/random_values.h"
#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

Cholesky cholesky_of(const SparseSymmetric& m) {
  Cholesky factor;
  factor.analyze(m);
  EXPECT_TRUE(factor.factorize(m));
  return factor;
}

/// Of elastic_grid(n), by a factor or over so many coarser ones.
std::shared_ptr<CoarseGrid> coarse_grid(int n, int coarser = 0) {
  SparseSymmetric m = test::elastic_grid(n);
  if (coarser == 0) return std::make_shared<CoarseGrid>(test::to_twice_as_fine(n), cholesky_of(m));
  return std::make_shared<CoarseGrid>(test::to_twice_as_fine(n), std::move(m),
                                      coarse_grid(n / 2, coarser - 1));
}

int iterations(int n, int coarser) {
  const SparseSymmetric A = test::elastic_grid(n);
  const std::shared_ptr<CoarseGrid> grid = coarse_grid(n / 2, coarser);
  VCycle cycle(A, *grid);
  const Eigen::VectorXd b = test::random_values(A.size(), 7);
  const ConjugateGradientSolution found =
      conjugate_gradients(A, b, std::ref(cycle), {.least_gain = 1e-12, .most_iterations = 60});
  EXPECT_EQ(found.end, ConjugateGradientEnd::converged);
  Eigen::VectorXd image(b.size());
  multiply(A, found.x, image);
  EXPECT_LT((image - b).norm(), 1e-4 * b.norm());
  return found.iterations;
}

TEST(VCycle, IsSymmetricAndPositiveDefinite) {
  const SparseSymmetric A = test::elastic_grid(8);
  for (const int coarser : {0, 1}) {
    SCOPED_TRACE(coarser);
    const std::shared_ptr<CoarseGrid> grid = coarse_grid(4, coarser);
    VCycle cycle(A, *grid);
    Eigen::MatrixXd M(A.size(), A.size());
    for (int i = 0; i < A.size(); ++i) M.col(i) = cycle(Eigen::VectorXd::Unit(A.size(), i));
    EXPECT_LT((M - M.transpose()).norm(), 1e-5 * M.norm()) << "the factor's single precision";
    EXPECT_GT(test::smallest_eigenvalue(0.5 * (M + M.transpose())), 0);
  }
}

TEST(VCycle, LeavesConjugateGradientsAsFewIterationsHoweverFineTheMesh) {
  const int small = iterations(16, 0);
  EXPECT_GT(small, 3);
  EXPECT_LT(small, 20);
  EXPECT_LE(iterations(64, 0), small + 2);
  EXPECT_LE(iterations(64, 2), small + 4) << "on three coarser meshes";
}

TEST(VCycle, HasTheSameBitsWithAnyNumberOfThreads) {
  const auto result = [] {
    const SparseSymmetric A = test::elastic_grid(64);
    const std::shared_ptr<CoarseGrid> grid = coarse_grid(32, 1);
    VCycle cycle(A, *grid);
    return cycle(test::random_values(A.size(), 3));
  };
  const Eigen::VectorXd one = result();
  Team team(3);
  const WithTeam with(&team);
  EXPECT_EQ(result(), one);
}

TEST(CoarseGrid, DoesNotServeWhereItsMatrixIsIndefinite) {
  SparseSymmetric m = test::elastic_grid(4);
  add_block(m, 7, 7, -100 * Eigen::Matrix2d::Identity());
  EXPECT_TRUE(coarse_grid(4, 1)->is_definite());
  EXPECT_FALSE(CoarseGrid(test::to_twice_as_fine(4), m, coarse_grid(2)).is_definite());
}

}  // namespace
}  // namespace foldless
