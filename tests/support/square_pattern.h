// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless::test {

/// The pattern of a square of so many nodes a side, which diagonals make a mesh of triangles.
inline SparseSymmetric square_pattern(int side) {
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int node = i * side + j;
      if (j + 1 < side) edges.emplace_back(node, node + 1);
      if (i + 1 < side) edges.emplace_back(node, node + side);
      if (i + 1 < side && j + 1 < side) edges.emplace_back(node, node + side + 1);
    }
  return sparse_symmetric(side * side, edges);
}

}  // namespace foldless::test
