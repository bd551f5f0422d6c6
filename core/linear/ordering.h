// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// An order of the nodes with little fill in the Cholesky factor: approximate minimum degree
/// [ADD96] on the graph of the nodes, a quarter of the work of one of the unknowns and as good.
/// Throws std::bad_alloc.
std::vector<int> fill_reducing_ordering(const SparseSymmetric& matrix);

}  // namespace foldless
