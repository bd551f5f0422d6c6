// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/symbolic_analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

#include "core/linear/ordering.h"
#include "core/threads/team.h"
#include "tests/support/random_symmetric.h"
#include "tests/support/square_pattern.h"

namespace foldless {
namespace {

SymbolicFactor factor_of(const SparseSymmetric& m, double parted_from) {
  return symbolic_factor(elimination_tree(m, fill_reducing_ordering(m)), parted_from);
}

/// The columns of the factor of a graph by the elimination game: nodes after each in the order.
std::vector<std::set<int>> eliminated(const SparseSymmetric& m, const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  std::vector<std::set<int>> columns(order.size());
  for (std::size_t j = 0; j < order.size(); ++j)
    for (int k = m.graph_start[j]; k < m.graph_start[j + 1]; ++k) {
      const auto [first, second] = std::minmax(
          places[j], places[static_cast<std::size_t>(m.graph[static_cast<std::size_t>(k)])]);
      columns[static_cast<std::size_t>(first)].insert(second);
    }
  for (auto& column : columns)
    if (!column.empty()) {
      std::set<int>& next = columns[static_cast<std::size_t>(*column.begin())];
      next.insert(std::next(column.begin()), column.end());
    }
  return columns;
}

TEST(SymbolicAnalysis, RowsOfASupernodeAreThoseOfItsLastColumn) {
  std::size_t parted = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = test::random_symmetric(seed);
    const SymbolicFactor factor = factor_of(m, 0);
    parted += factor.subtrees.size() > 1 ? 1 : 0;
    const std::vector<std::set<int>> columns = eliminated(m, factor.order);
    for (const Supernode& s : factor.supernodes) {
      const std::set<int>& last = columns[static_cast<std::size_t>((s.first + s.columns) / 2 - 1)];
      EXPECT_TRUE(std::ranges::equal(factor.rows_of(s), last)) << "from " << s.first;
    }
  }
  EXPECT_GT(parted, 30U);
}

using Block = std::tuple<int, int, int>;

std::multiset<Block> blocks_of(const SymbolicFactor& factor, std::size_t k) {
  const std::size_t end = k + 1 < factor.supernodes.size() ? factor.supernodes[k + 1].block_start
                                                           : factor.blocks.size();
  std::multiset<Block> blocks;
  for (std::size_t i = factor.supernodes[k].block_start; i < end; ++i) {
    const BlockOfPanel& block = factor.blocks[i];
    blocks.emplace(block.first, block.second, block.target);
  }
  return blocks;
}

TEST(SymbolicAnalysis, IsTheSameInSubtreesThatThreadsShare) {
  SparseSymmetric m = test::square_pattern(70);
  const SymbolicFactor whole = factor_of(m, std::numeric_limits<double>::infinity());
  ASSERT_TRUE(whole.subtrees.empty());
  Team team(3);
  const WithTeam with(&team);
  m = test::square_pattern(70);  // with ranges for threads
  const SymbolicFactor parted = factor_of(m, 0);
  ASSERT_GT(parted.subtrees.size(), 10U);
  EXPECT_EQ(parted.order, whole.order);
  EXPECT_EQ(parted.rows, whole.rows);
  EXPECT_EQ(parted.places, whole.places);
  ASSERT_EQ(parted.supernodes.size(), whole.supernodes.size());
  for (std::size_t k = 0; k < whole.supernodes.size(); ++k)
    EXPECT_EQ(blocks_of(parted, k), blocks_of(whole, k)) << k;
}

}  // namespace
}  // namespace foldless
