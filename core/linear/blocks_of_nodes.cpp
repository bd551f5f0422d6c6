// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/blocks_of_nodes.h"

#include <algorithm>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// Calls visit(node, block) for the blocks of the nodes of a range.
template <class Visit>
void visit_range(const SparseSymmetric& A, int range, const Visit& visit) {
  for (const auto& [row, column, place] : A.crossings[static_cast<std::size_t>(range)])
    visit(row, BlockOfNode{column, place});
  const int begin = range * A.range, end = std::min(begin + A.range, A.nodes);
  for (int j = begin; j < end; ++j) {
    const auto node = static_cast<std::size_t>(j);
    BlockPlace place{A.first_column(node) + 2, A.second_column(node) + 1};
    for (int k = A.graph_start[node]; k < A.graph_start[node + 1]; ++k) {
      const int i = A.graph[static_cast<std::size_t>(k)];
      visit(j, BlockOfNode{i, place});
      if (i < end) visit(i, BlockOfNode{j, place});
      place.first_column += 2;
      place.second_column += 2;
    }
  }
}

/// The ranges of products, so that a thread writes the lists of its own nodes alone.
template <class Visit>
void visit_ranges(const SparseSymmetric& A, const Visit& visit) {
  in_parallel(static_cast<int>(A.crossings.size()),
              [&](int range) { visit_range(A, range, visit); });
}

}  // namespace

ItemLists<BlockOfNode> blocks_of_nodes(const SparseSymmetric& matrix) {
  ItemLists<BlockOfNode> lists;
  lists.start.assign(static_cast<std::size_t>(matrix.nodes) + 1, 0);
  visit_ranges(matrix, [&](int node, const BlockOfNode&) {
    ++lists.start[static_cast<std::size_t>(node) + 1];
  });
  lists.make_room();
  std::vector<std::size_t> next(lists.start.begin(), lists.start.end() - 1);
  visit_ranges(matrix, [&](int node, const BlockOfNode& block) {
    lists.items[next[static_cast<std::size_t>(node)]++] = block;
  });
  return lists;
}

std::vector<int> places_in(const std::vector<int>& order) {
  std::vector<int> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  return places;
}

ItemLists<BlockOfNode> in_order(const ItemLists<BlockOfNode>& blocks,
                                const std::vector<int>& order) {
  const std::vector<int> places = places_in(order);
  ItemLists<BlockOfNode> lists;
  lists.start.assign(1, 0);
  lists.start.reserve(blocks.start.size());
  for (const int node : order) lists.start.push_back(blocks.of(node).size());
  lists.make_room();
  constexpr std::ptrdiff_t kListsTogether = 2048;
  each_in_ranges(std::ssize(order), kListsTogether, [&](std::ptrdiff_t k) {
    const auto place = static_cast<std::size_t>(k);
    BlockOfNode* next = lists.items.data() + lists.start[place];
    for (const BlockOfNode& block : blocks.of(order[place]))
      *next++ = {places[static_cast<std::size_t>(block.other)], block.place};
  });
  return lists;
}

}  // namespace foldless
