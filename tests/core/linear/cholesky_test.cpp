// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/cholesky.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>
#include <vector>

#include "tests/support/dense_matrix.h"

namespace foldless {
namespace {

using NodePairs = std::vector<std::pair<int, int>>;

/// The Laplacian of a graph plus `diagonal`, the same for x and y.
SparseSymmetric laplacian(int nodes, const NodePairs& edges, double diagonal) {
  SparseSymmetric m = sparse_symmetric(nodes, edges);
  const auto add = [&m](int i, int j, double value) {
    const BlockPlace place = find_block(m, i, j);
    m.value[static_cast<std::size_t>(place.first_column)] += value;
    m.value[static_cast<std::size_t>(place.second_column) + (i == j ? 0 : 1)] += value;
  };
  for (const auto& [a, b] : edges) {
    add(a, a, 1);
    add(b, b, 1);
    add(std::max(a, b), std::min(a, b), -1);
  }
  for (int i = 0; i < nodes; ++i) add(i, i, diagonal);
  return m;
}

SparseSymmetric ring(int nodes, double diagonal) {
  NodePairs edges;
  for (int i = 0; i < nodes; ++i) edges.emplace_back(i, (i + 1) % nodes);
  return laplacian(nodes, edges, diagonal);
}

/// A square grid of n × n nodes, whose factor has dense blocks.
SparseSymmetric laplacian_of_grid(int n) {
  NodePairs edges;
  for (int i = 0; i < n * n; ++i) {
    if (i % n + 1 < n) edges.emplace_back(i, i + 1);
    if (i + n < n * n) edges.emplace_back(i, i + n);
  }
  return laplacian(n * n, edges, 0.1);
}

Eigen::VectorXd solution_of(const SparseSymmetric& m) {
  Cholesky cholesky;
  cholesky.analyze(m);
  EXPECT_TRUE(cholesky.factorize(m));
  return cholesky.solve(Eigen::VectorXd::LinSpaced(m.size(), -1, 2));
}

double residual(const SparseSymmetric& m, double shift, const Eigen::VectorXd& x,
                const Eigen::VectorXd& b) {
  Eigen::VectorXd r = b - shift * x;
  test::for_each_entry(m, [&](int row, int column, double value) {
    r[row] -= value * x[column];
    if (row != column) r[column] -= value * x[row];
  });
  return r.norm() / b.norm();
}

TEST(Cholesky, TwoLargeSolvesAtOnceDoNotDisturbEachOther) {
  const SparseSymmetric m = laplacian_of_grid(50);
  const Eigen::VectorXd alone = solution_of(m);
  std::array<int, 2> spoilt{};
  {
    std::vector<std::jthread> solvers;
    for (int& count : spoilt)
      solvers.emplace_back([&] {
        for (int k = 0; k < 20; ++k) count += solution_of(m) != alone;
      });
  }
  EXPECT_EQ(spoilt, (std::array<int, 2>{}));
}

TEST(Cholesky, AVeryLargeFactorServesInBothPrecisionsTimeAndAgain) {
  const SparseSymmetric m = laplacian_of_grid(450);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  Cholesky cholesky;
  cholesky.analyze(m);
  for (const double shift : {1.0, 2.0}) {
    ASSERT_TRUE(cholesky.factorize(m, shift));
    EXPECT_LT(residual(m, shift, cholesky.precondition(b), b), 1e-4);
    EXPECT_LT(residual(m, shift, cholesky.solve(b), b), 1e-12);
  }
}

// Both sizes: a few supernodes and many.
class CholeskyTest : public testing::TestWithParam<int> {};

TEST_P(CholeskyTest, SolvesShiftedSystems) {
  const SparseSymmetric m = ring(GetParam(), 0.5);
  Cholesky cholesky;
  EXPECT_FALSE(cholesky.is_analyzed());
  cholesky.analyze(m);
  for (const double shift : {0.0, 10.0}) {
    ASSERT_TRUE(cholesky.factorize(m, shift));
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
    EXPECT_LT(residual(m, shift, cholesky.solve(b), b), 1e-12);
  }
}

TEST_P(CholeskyTest, SaysWhenAMatrixIsNotPositiveDefiniteAndGoesOn) {
  const SparseSymmetric m = ring(GetParam(), -0.5);
  Cholesky cholesky;
  cholesky.analyze(m);
  EXPECT_FALSE(cholesky.factorize(m));
  EXPECT_FALSE(cholesky.has_factor());
  ASSERT_TRUE(cholesky.factorize(m, 1));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(m.size());
  EXPECT_LT(residual(m, 1, cholesky.solve(b), b), 1e-12);
}

TEST_P(CholeskyTest, IsStoppedAndGoesOnUnderAnotherToken) {
  const SparseSymmetric m = ring(GetParam(), 1);
  Cholesky cholesky;
  cholesky.analyze(m);
  std::stop_source stop;
  cholesky.obey(stop.get_token());
  ASSERT_TRUE(cholesky.factorize(m));
  stop.request_stop();
  EXPECT_TRUE(cholesky.is_stopped());
  EXPECT_FALSE(cholesky.factorize(m));
  EXPECT_FALSE(cholesky.has_factor());
  cholesky.obey({});
  ASSERT_TRUE(cholesky.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(m.size());
  EXPECT_LT(residual(m, 0, cholesky.solve(b), b), 1e-12);
}

TEST_P(CholeskyTest, AnOrderingServesAnotherPatternOfTheSameSize) {
  Cholesky cholesky;
  cholesky.analyze(ring(GetParam(), 1));
  std::vector<std::pair<int, int>> edges{{0, GetParam() - 1}, {0, GetParam() / 2}};
  for (int i = 0; i + 1 < GetParam(); ++i) edges.emplace_back(i, i + 1);
  SparseSymmetric m = sparse_symmetric(GetParam(), edges);
  for (int i = 0; i < m.nodes; ++i) {
    const BlockPlace place = find_block(m, i, i);
    m.value[static_cast<std::size_t>(place.first_column)] = 2;
    m.value[static_cast<std::size_t>(place.second_column)] = 4;
  }
  cholesky.analyze(m);
  ASSERT_TRUE(cholesky.factorize(m));
  const Eigen::VectorXd x = cholesky.solve(Eigen::VectorXd::Ones(m.size()));
  EXPECT_NEAR(x[0], 0.5, 1e-15);
  EXPECT_NEAR(x[1], 0.25, 1e-15);
}

TEST_P(CholeskyTest, AnOrderingOfAnotherSizeIsNotKept) {
  Cholesky cholesky;
  cholesky.analyze(ring(GetParam() + 3, 1));
  const SparseSymmetric m = ring(GetParam(), 1);
  cholesky.analyze(m);
  ASSERT_TRUE(cholesky.factorize(m));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(m.size(), -1, 2);
  ASSERT_EQ(cholesky.solve(b).size(), b.size());
  EXPECT_LT(residual(m, 0, cholesky.solve(b), b), 1e-12);
}

TEST(Cholesky, APatternThatHasLittleToDoWithTheOneBeforeIsOrderedAnew) {
  constexpr int kSide = 40, kNodes = kSide * kSide;
  // A grid whose nodes are numbered row by row, or in leaps.
  const auto grid = [](int leap) {
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i < kNodes; ++i) {
      if ((i + 1) % kSide != 0) edges.emplace_back(i * leap % kNodes, (i + 1) * leap % kNodes);
      if (i + kSide < kNodes) edges.emplace_back(i * leap % kNodes, (i + kSide) * leap % kNodes);
    }
    return sparse_symmetric(kNodes, edges);
  };
  Cholesky cholesky, anew;
  cholesky.analyze(grid(1));
  cholesky.analyze(grid(391));
  anew.analyze(grid(391));
  EXPECT_EQ(cholesky.values(), anew.values());
}

TEST(Cholesky, SomeOfItsNodesAloneHaveLittleFillInTheOrderOfTheirElimination) {
  const SparseSymmetric whole = laplacian_of_grid(40);
  Cholesky cholesky;
  cholesky.analyze(whole);
  std::vector<int> nodes;  // of a square of 20 × 20 in it, and backwards
  for (int i = 19; i >= 0; --i)
    for (int j = 19; j >= 0; --j) nodes.push_back(40 * i + j);
  const auto part_in_order = [](const std::vector<int>& of) {
    std::vector<int> place(1600, -1);
    for (std::size_t k = 0; k < of.size(); ++k)
      place[static_cast<std::size_t>(of[k])] = static_cast<int>(k);
    NodePairs edges;
    for (std::size_t node = 0; node < 1600; ++node)
      for (const std::size_t other : {node + 1, node + 40})
        if (other < 1600 && place[node] >= 0 && place[other] >= 0)
          edges.emplace_back(place[node], place[other]);
    return laplacian(400, edges, 0.1);
  };
  Cholesky as_they_are;
  as_they_are.analyze_in_order(part_in_order(nodes));
  std::vector<int> sorted = nodes;
  cholesky.sort_by_elimination(sorted);
  EXPECT_TRUE(std::ranges::is_permutation(sorted, nodes));
  const SparseSymmetric part = part_in_order(sorted);
  Cholesky in_order, anew;
  in_order.analyze_in_order(part);
  anew.analyze(part);
  EXPECT_LT(static_cast<double>(in_order.values()), 1.2 * static_cast<double>(anew.values()));
  EXPECT_GT(static_cast<double>(as_they_are.values()), 1.5 * static_cast<double>(anew.values()));
  ASSERT_TRUE(in_order.factorize(part));
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(part.size(), -1, 2);
  EXPECT_LT(residual(part, 0, in_order.solve(b), b), 1e-12);
}

TEST_P(CholeskyTest, ACopyHasTheFactor) {
  const SparseSymmetric m = ring(GetParam(), 1);
  Cholesky cholesky;
  cholesky.analyze(m);
  ASSERT_TRUE(cholesky.factorize(m));
  Cholesky copy = cholesky;
  ASSERT_TRUE(copy.has_factor());
  const Eigen::VectorXd b = Eigen::VectorXd::Ones(m.size());
  EXPECT_EQ(copy.solve(b), cholesky.solve(b));
  ASSERT_TRUE(copy.factorize(m, 3));
  EXPECT_LT(residual(m, 3, copy.solve(b), b), 1e-12);
  EXPECT_LT(residual(m, 0, cholesky.solve(b), b), 1e-12) << "the original's is its own";
}

INSTANTIATE_TEST_SUITE_P(Sizes, CholeskyTest, testing::Values(7, 3000));

}  // namespace
}  // namespace foldless
