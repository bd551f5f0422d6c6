// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/linear/sparse_symmetric.h"
#include "core/threads/unfilled_vector.h"

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
  std::size_t row_start = 0;    ///< where `rows` and `places` of the symbolic factor tell of it
  std::size_t value_start = 0;  ///< where its panel begins
  /// Where its update matrix begins, below × below: in a subtree, but for its root, in stacks that
  /// subtrees have in turn.
  std::size_t update_start = 0;
  std::size_t block_start = 0;  ///< where `blocks` begin that belong to it

  int rows() const { return columns + below; }
};

/// Where a block of the matrix goes.
struct BlockOfPanel {
  int first, second;  ///< its columns in the values of the matrix, as BlockPlace
  int target;         ///< in the panel; ~target where it is transposed
};

/// Supernodes below one of them, with it, which are the last before it. Two subtrees have nothing
/// to do with each other, so that each is a task of its own.
struct Subtree {
  int first = 0;        ///< supernode
  int root = 0;         ///< the last of its supernodes
  int outer_start = 0;  ///< where its outer places begin, counted in nodes from the matrix's end on
};

/// The pattern of the Cholesky factor of a matrix made of full 2 × 2 blocks, and how it comes about
/// front by front [Liu92]: a supernode's front is its panel, and the update matrix that it hands up
/// to its parent. The analysis is that of the graph of the nodes, a quarter of the matrix.
struct SymbolicFactor {
  std::vector<int> order;             ///< the node of each place in the order of elimination
  std::vector<int> place;             ///< of each node in that order
  std::vector<int> parent;            ///< the elimination tree of the places; −1 at a root
  std::vector<Supernode> supernodes;  ///< children before their parents
  UnfilledVector<int> rows;           ///< places of the nodes below the columns, sorted
  UnfilledVector<int> places;  ///< of the same nodes in the front of the parent, counted in nodes
  UnfilledVector<BlockOfPanel> blocks;  ///< but for those on the diagonal
  std::vector<Subtree> subtrees;        ///< of about equal work; none where there is little in all
  std::vector<int> top;                 ///< supernodes in no subtree, in their order
  /// The same as `rows`, but what a subtree has in rows above it is at places of its own beyond the
  /// end of the matrix, its *outer* places, in the order of its root's rows.
  UnfilledVector<int> solve_rows;
  std::size_t values = 0;           ///< of all panels
  std::size_t updates = 0;          ///< room for the update matrices that wait for their parents
  std::size_t subtree_updates = 0;  ///< the same of one subtree at a time, but for its root's
  int outer = 0;                    ///< outer places of all subtrees
  int largest_front = 0;            ///< rows of the largest panel

  int size() const { return 2 * static_cast<int>(order.size()); }
  /// Of a vector with its outer places.
  int solve_size() const { return size() + 2 * outer; }
  std::span<const int> rows_of(const Supernode& s) const { return of(rows, s); }
  std::span<const int> places_of(const Supernode& s) const { return of(places, s); }

 private:
  static std::span<const int> of(const UnfilledVector<int>& array, const Supernode& s) {
    return {array.data() + s.row_start, static_cast<std::size_t>(s.below / 2)};
  }
};

}  // namespace foldless
