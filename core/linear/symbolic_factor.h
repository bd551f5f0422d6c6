// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// Columns of the factor, one after the other, that have the same rows below them: a dense panel of
/// rows() × columns values, column after column, of which the first rows are the columns. Columns
/// and rows are of unknowns; two are of one node, so that all of these numbers are even.
struct Supernode {
  int first = 0;     ///< column of the factor
  int columns = 0;   ///< > 0
  int below = 0;     ///< rows below the columns
  int parent = -1;   ///< the supernode whose columns hold the first row below; −1: a root
  int child = -1;    ///< the first that this one is the parent of; −1: none
  int sibling = -1;  ///< the next child of the parent; −1: none
  std::size_t row_start = 0;     ///< where `rows` and `places` of the symbolic factor tell of it
  std::size_t value_start = 0;   ///< where its panel begins
  std::size_t update_start = 0;  ///< where its update matrix begins, below × below ...
  int update_stack = 0;          ///< ... in which of two stacks
  std::size_t block_start = 0;   ///< where `blocks` begin that belong to it

  int rows() const { return columns + below; }
};

/// Where a block of the matrix goes.
struct BlockOfPanel {
  int first, second;  ///< its columns in the values of the matrix, as BlockPlace
  int target;         ///< in the panel; ~target where it is transposed
};

/// The pattern of the Cholesky factor of a matrix made of full 2 × 2 blocks, and how it comes about
/// front by front [Liu92]: a supernode's front is its panel, and the update matrix that it hands up
/// to its parent. The analysis is that of the graph of the nodes, a quarter of the matrix.
struct SymbolicFactor {
  std::vector<int> order;             ///< the node of each place in the order of elimination
  std::vector<Supernode> supernodes;  ///< children before their parents
  std::vector<int> rows;              ///< places of the nodes below the columns, sorted
  std::vector<int> places;  ///< of the same nodes in the front of the parent, counted in nodes
  std::vector<BlockOfPanel> blocks;  ///< but for those on the diagonal
  std::size_t values = 0;            ///< of all panels
  std::size_t stack_sizes[2] = {};   ///< of the update matrices that wait for their parents at once

  int size() const { return 2 * static_cast<int>(order.size()); }
  std::span<const int> rows_of(const Supernode& s) const { return of(rows, s); }
  std::span<const int> places_of(const Supernode& s) const { return of(places, s); }

 private:
  static std::span<const int> of(const std::vector<int>& array, const Supernode& s) {
    return {array.data() + s.row_start, static_cast<std::size_t>(s.below / 2)};
  }
};

/// `order` is a fill-reducing one of the nodes; an equivalent one is used. Throws Error where a
/// panel has more than 2³¹ values.
SymbolicFactor symbolic_factor(const SparseSymmetric& matrix, const std::vector<int>& order);

}  // namespace foldless
