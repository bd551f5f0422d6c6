// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/later_blocks.h"

#include <algorithm>
#include <numeric>

namespace foldless {
namespace {

/// Calls put(column, block) for each block below the diagonal.
template <class Put>
void visit_blocks(const SparseSymmetric& matrix, const std::vector<int>& position, const Put& put) {
  for (std::size_t node = 0; node < position.size(); ++node) {
    int first = matrix.first_column(node) + 2;
    int second = matrix.second_column(node) + 1;
    const int a = position[node];
    for (int k = matrix.graph_start[node]; k < matrix.graph_start[node + 1]; ++k) {
      const int other = matrix.graph[static_cast<std::size_t>(k)];
      const int b = position[static_cast<std::size_t>(other)];
      put(static_cast<std::size_t>(std::min(a, b)),
          LaterBlock{std::max(a, b), first, second, b < a});
      first += 2;
      second += 2;
    }
  }
}

}  // namespace

LaterBlocks later_blocks(const SparseSymmetric& matrix, const std::vector<int>& position) {
  LaterBlocks later;
  later.start.assign(position.size() + 1, 0);
  visit_blocks(matrix, position,
               [&](std::size_t column, const LaterBlock&) { ++later.start[column + 1]; });
  std::partial_sum(later.start.begin(), later.start.end(), later.start.begin());
  later.blocks.resize(matrix.graph.size());
  std::vector<std::size_t> next(later.start.begin(), later.start.end() - 1);
  visit_blocks(matrix, position, [&](std::size_t column, const LaterBlock& block) {
    later.blocks[next[column]++] = block;
  });
  return later;
}

}  // namespace foldless
