// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// A block of a matrix below the diagonal, where its nodes are in another order.
struct LaterBlock {
  int row;            ///< place of the later of its two nodes
  int first, second;  ///< its columns in the values of the matrix, as BlockPlace
  bool is_transposed;
};

/// The blocks of a matrix below the diagonal by the places of the earlier of their nodes.
struct LaterBlocks {
  std::vector<std::size_t> start;  ///< #nodes + 1
  std::vector<LaterBlock> blocks;

  std::span<const LaterBlock> of(int column) const {
    const auto k = static_cast<std::size_t>(column);
    return {blocks.data() + start[k], start[k + 1] - start[k]};
  }
};

/// `position` is the place of each node in the other order.
LaterBlocks later_blocks(const SparseSymmetric& matrix, const std::vector<int>& position);

}  // namespace foldless
