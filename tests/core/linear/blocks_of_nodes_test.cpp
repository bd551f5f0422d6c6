// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/blocks_of_nodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "core/threads/team.h"
#include "tests/support/random_symmetric.h"
#include "tests/support/square_pattern.h"

namespace foldless {
namespace {

/// A node, the other one, and where their block is.
using Listed = std::tuple<int, int, int, int>;

std::multiset<Listed> listed(const ItemLists<BlockOfNode>& lists) {
  std::multiset<Listed> all;
  for (int node = 0; node < lists.count(); ++node)
    for (const auto& [other, place] : lists.of(node))
      all.emplace(node, other, place.first_column, place.second_column);
  return all;
}

/// What find_block() says of every edge, from both sides.
std::multiset<Listed> expected(const SparseSymmetric& m) {
  std::multiset<Listed> all;
  for (int j = 0; j < m.nodes; ++j)
    for (int k = m.graph_start[static_cast<std::size_t>(j)];
         k < m.graph_start[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = m.graph[static_cast<std::size_t>(k)];
      const auto [first, second] = find_block(m, i, j);
      all.emplace(i, j, first, second);
      all.emplace(j, i, first, second);
    }
  return all;
}

TEST(BlocksOfNodes, AreThoseOfEveryNeighbour) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SparseSymmetric m = test::random_symmetric(seed);
    EXPECT_EQ(listed(blocks_of_nodes(m)), expected(m));
  }
}

TEST(BlocksOfNodes, AreTheSameWhereThreadsShareThem) {
  Team team(3);
  const WithTeam with(&team);
  const SparseSymmetric m = test::square_pattern(70);
  ASSERT_GT(m.crossings.size(), 3U);
  EXPECT_EQ(listed(blocks_of_nodes(m)), expected(m));
}

TEST(BlocksOfNodes, InAnOrderGoByPlaces) {
  Team team(3);
  const WithTeam with(&team);
  const SparseSymmetric m = test::square_pattern(70);
  std::vector<int> order(static_cast<std::size_t>(m.nodes));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, std::mt19937(1));
  const std::vector<int> places = places_in(order);
  for (int k = 0; k < m.nodes; ++k)
    ASSERT_EQ(places[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])], k);
  std::multiset<Listed> by_places;
  for (const auto& [node, other, first, second] : expected(m))
    by_places.emplace(places[static_cast<std::size_t>(node)],
                      places[static_cast<std::size_t>(other)], first, second);
  EXPECT_EQ(listed(in_order(blocks_of_nodes(m), order)), by_places);
}

}  // namespace
}  // namespace foldless
