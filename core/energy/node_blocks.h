// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/matrix2.h"
#include "core/linear/sparse_symmetric.h"

// What add_block() of core/linear does, inlined and without Eigen: each triangle adds six blocks in
// every step, which makes a frame of 5,000 triangles nearly a tenth shorter.

namespace foldless {

/// Adds the block of a node with itself. Precondition: `block` is symmetric.
inline void add_diagonal_block(const Matrix2<double>& block, int node, SparseSymmetric& matrix) {
  const auto j = static_cast<std::size_t>(node);
  double* first = &matrix.value[static_cast<std::size_t>(matrix.first_column(j))];
  first[0] += block.a;
  first[1] += block.b;
  matrix.value[static_cast<std::size_t>(matrix.second_column(j))] += block.d;
}

/// Adds the block of rows of one node and columns of an earlier one. Precondition: the pattern has
/// it.
inline void add_later_block(const Matrix2<double>& block, int row, int column,
                            SparseSymmetric& matrix) {
  const BlockPlace place = find_block(matrix, row, column);
  double* first = &matrix.value[static_cast<std::size_t>(place.first_column)];
  double* second = &matrix.value[static_cast<std::size_t>(place.second_column)];
  first[0] += block.a;
  first[1] += block.b;
  second[0] += block.c;
  second[1] += block.d;
}

}  // namespace foldless
