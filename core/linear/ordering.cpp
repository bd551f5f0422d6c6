// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/ordering.h"

#include <amd.h>

#include <new>
#include <numeric>

namespace foldless {

std::vector<int> fill_reducing_ordering(const SparseSymmetric& matrix) {
  std::vector<int> order(static_cast<std::size_t>(matrix.nodes));
  std::iota(order.begin(), order.end(), 0);
  if (matrix.graph.empty()) return order;  // the library takes an empty array for a missing one
  if (amd_order(matrix.nodes, matrix.graph_start.data(), matrix.graph.data(), order.data(), nullptr,
                nullptr) != AMD_OK)
    throw std::bad_alloc();
  return order;
}

}  // namespace foldless
