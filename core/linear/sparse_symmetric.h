// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "core/threads/unfilled_vector.h"

namespace foldless {

/// Where the block of nodes i > j is in `value`: rows of column 2j at [0], of column 2j+1 at [1];
/// each is the first of two neighbouring entries. For i = j: entries (2j,2j) and (2j+1,2j+1),
/// with (2j+1,2j) right after the first.
struct BlockPlace {
  int first_column;
  int second_column;
};

/// The lower triangle of a symmetric matrix by columns, rows sorted, made of 2×2 blocks over an
/// undirected graph whose nodes are vertices: unknowns 2i and 2i+1 belong to node i.
struct SparseSymmetric {
  int nodes = 0;
  std::vector<int> graph_start;  ///< #nodes + 1: where the later neighbours of a node begin
  std::vector<int> graph;        ///< neighbours with a larger index, sorted, node after node
  UnfilledVector<double> value;  ///< 3 #nodes + 4 #graph

  /// A block of a node and one in an earlier range.
  struct Crossing {
    int row, column;
    BlockPlace place;
  };
  int range = 0;  ///< nodes that a thread takes together in a product, > 0 where there are nodes
  std::vector<std::vector<Crossing>> crossings;  ///< by the ranges of the rows, sorted by columns

  int size() const { return 2 * nodes; }
  /// Where the values of column 2j begin, for j = #nodes where they end: rows 2j, 2j+1 and those of
  /// the later neighbours.
  int first_column(std::size_t j) const { return 3 * static_cast<int>(j) + 4 * graph_start[j]; }
  /// Where those of column 2j+1 begin: row 2j+1 and those of the later neighbours.
  int second_column(std::size_t j) const {
    return first_column(j) + 2 + 2 * (graph_start[j + 1] - graph_start[j]);
  }
};

/// The pattern of a graph given by its edges (pairs of node indices, any order, repeats allowed);
/// all values are zero.
SparseSymmetric sparse_symmetric(int nodes, const std::vector<std::pair<int, int>>& edges);
/// The pattern of a graph given as SparseSymmetric has it; all values are zero.
SparseSymmetric sparse_symmetric(std::vector<int> graph_start, std::vector<int> graph);

/// Precondition: the pattern has the block.
inline BlockPlace find_block(const SparseSymmetric& matrix, int i, int j) {
  const int first = matrix.first_column(static_cast<std::size_t>(j));
  const int second = matrix.second_column(static_cast<std::size_t>(j));
  if (i == j) return {first, second};
  // A vertex has three later neighbours on average: too few for a binary search.
  const int* const begin =
      &matrix.graph[static_cast<std::size_t>(matrix.graph_start[static_cast<std::size_t>(j)])];
  const int* neighbour = begin;
  while (*neighbour != i) ++neighbour;
  const int rank = static_cast<int>(neighbour - begin);
  return {first + 2 + 2 * rank, second + 1 + 2 * rank};
}

/// y = A x, with the same bits however many threads share it.
void multiply(const SparseSymmetric& A, const Eigen::VectorXd& x, Eigen::VectorXd& y);

/// Adds the block of nodes i ≥ j, for i = j its lower triangle. Precondition: the pattern has it.
void add_block(SparseSymmetric& matrix, int i, int j, const Eigen::Matrix2d& block);
/// Adds the symmetric block of a triangle, whose corners are the nodes; a corner of node −1 has no
/// rows in the matrix. Precondition: the pattern has the block.
void add_block(SparseSymmetric& matrix, const std::array<int, 3>& nodes,
               const Eigen::Matrix<double, 6, 6>& block);

}  // namespace foldless
