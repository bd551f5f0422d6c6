// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/item_lists.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// A block of a matrix beside the diagonal, as one of its two nodes sees it.
struct BlockOfNode {
  int other;         ///< the other one
  BlockPlace place;  ///< in the values, where its row is the larger one of the two nodes
};

/// Those of every node: each block is in two lists.
ItemLists<BlockOfNode> blocks_of_nodes(const SparseSymmetric& matrix);

/// The same by places in an order of the nodes, of which `other` is one then.
ItemLists<BlockOfNode> in_order(const ItemLists<BlockOfNode>& blocks,
                                const std::vector<int>& order);
/// The place of each node in an order.
std::vector<int> places_in(const std::vector<int>& order);

}  // namespace foldless
