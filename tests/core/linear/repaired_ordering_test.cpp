// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/repaired_ordering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/linear/elimination_tree.h"
#include "core/linear/ordering.h"

namespace foldless {
namespace {

using NodePair = std::pair<int, int>;

/// The edges of a square grid of so many nodes a side, each cell with a diagonal.
std::set<NodePair> grid_edges(int side) {
  std::set<NodePair> edges;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const int i = y * side + x;
      if (x + 1 < side) edges.insert({i, i + 1});
      if (y + 1 < side) edges.insert({i, i + side});
      if (x + 1 < side && y + 1 < side) edges.insert({i, i + side + 1});
    }
  return edges;
}

SparseSymmetric pattern_of(int nodes, const std::set<NodePair>& edges) {
  return sparse_symmetric(nodes, {edges.begin(), edges.end()});
}

/// Flips the diagonals of some cells.
void flip(std::set<NodePair>& edges, int side, int count, std::mt19937& random) {
  std::uniform_int_distribution<int> cell(0, side - 2);
  for (int k = 0; k < count; ++k) {
    const int i = cell(random) * side + cell(random);
    if (edges.erase({i, i + side + 1}) == 1) edges.insert({i + 1, i + side});
  }
}

double work_of(const SparseSymmetric& m, const std::vector<int>& order) {
  return elimination_tree(m, order).work();
}

TEST(RepairedOrdering, IsTheSameWhereThePatternIs) {
  const SparseSymmetric m = pattern_of(900, grid_edges(30));
  const EliminationTree tree = elimination_tree(m, fill_reducing_ordering(m));
  EXPECT_EQ(repaired_ordering(m, tree.order, tree.parent), tree.order);
}

TEST(RepairedOrdering, IsNearlyAsGoodAsANewOneAfterFlips) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    constexpr int kSide = 60;
    std::set<NodePair> edges = grid_edges(kSide);
    SparseSymmetric m = pattern_of(kSide * kSide, edges);
    EliminationTree tree = elimination_tree(m, fill_reducing_ordering(m));
    const std::vector<int> first = tree.order;
    for (int round = 0; round < 4; ++round) {
      flip(edges, kSide, 100, random);
      m = pattern_of(kSide * kSide, edges);
      const std::vector<int> order = repaired_ordering(m, tree.order, tree.parent);
      std::vector<int> sorted = order;
      std::ranges::sort(sorted);
      for (int i = 0; i < kSide * kSide; ++i) ASSERT_EQ(sorted[static_cast<std::size_t>(i)], i);
      tree = elimination_tree(m, order);
    }
    const double anew = work_of(m, fill_reducing_ordering(m));
    EXPECT_LT(tree.work(), 1.5 * anew);
    EXPECT_GT(work_of(m, first), 2 * anew) << "there would be nothing to repair";
  }
}

TEST(RepairedOrdering, JoinsWhatHungTogetherNowhere) {
  // Two paths, each eliminated from its ends, and an edge between two of their ends.
  std::set<NodePair> edges;
  for (int i = 0; i + 1 < 10; ++i) edges.insert({i, i + 1}), edges.insert({10 + i, 11 + i});
  const SparseSymmetric apart = pattern_of(20, edges);
  const EliminationTree tree = elimination_tree(apart, fill_reducing_ordering(apart));
  edges.insert({0, 10});
  const SparseSymmetric joined = pattern_of(20, edges);
  const std::vector<int> order = repaired_ordering(joined, tree.order, tree.parent);
  EXPECT_TRUE(order.back() == 0 || order.back() == 10);
  // A path has a factor of two nodes a column; with one that comes last, of three at most.
  for (const int count : elimination_tree(joined, order).count) EXPECT_LE(count, 3);
}

}  // namespace
}  // namespace foldless
