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

/// The nodes of a matrix in an order.
struct NodeOrder {
  std::vector<int> nodes;   ///< by places
  std::vector<int> places;  ///< by nodes
};

/// The same by places, of which `other` is one then.
ItemLists<BlockOfNode> in_order(const ItemLists<BlockOfNode>& blocks, const NodeOrder& order);

}  // namespace foldless
