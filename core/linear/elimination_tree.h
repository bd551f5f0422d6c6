// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/blocks_of_nodes.h"

namespace foldless {

/// The elimination tree of a symmetric matrix whose nodes are eliminated in a postorder of it, so
/// that every node comes right after all its descendants [Liu90].
struct EliminationTree {
  std::vector<int> order;   ///< the node that is eliminated at each place
  std::vector<int> parent;  ///< by places; −1 at a root
  std::vector<int> count;   ///< nodes in a column of the factor of the graph, itself among them
  ItemLists<BlockOfNode> blocks;  ///< by places

  /// Σ of the squares of `count`: about the multiplications of a factorization, but for a factor.
  double work() const {
    double sum = 0;
    for (const double nodes : count) sum += nodes * nodes;
    return sum;
  }
};

/// The tree of a fill-reducing order, which is changed into an equivalent one that is a postorder.
EliminationTree elimination_tree(const SparseSymmetric& matrix, const std::vector<int>& order);

}  // namespace foldless
