// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// Neighbours in a graph whose nodes have an order, by their places in it.
struct OrderedNeighbours {
  std::vector<int> start;  ///< #nodes + 1
  std::vector<int> place;  ///< those of a node after those of the one before it

  std::span<const int> of(int k) const {
    const auto begin = static_cast<std::size_t>(start[static_cast<std::size_t>(k)]);
    const auto end = static_cast<std::size_t>(start[static_cast<std::size_t>(k) + 1]);
    return {place.data() + begin, end - begin};
  }
};

/// The elimination tree of a symmetric matrix whose nodes are eliminated in a postorder of it, so
/// that every node comes right after all its descendants [Liu90].
struct EliminationTree {
  std::vector<int> order;     ///< the node that is eliminated at each place
  std::vector<int> position;  ///< the place of each node
  std::vector<int> parent;    ///< by places; −1 at a root
  std::vector<int> count;     ///< nodes in a column of the factor of the graph, itself among them
  OrderedNeighbours earlier;  ///< the neighbours that are eliminated before a node

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
