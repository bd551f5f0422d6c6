// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// The symbolic factor of a matrix made of full 2 × 2 blocks. The analysis is that of the graph of
/// its nodes, which is a quarter of the matrix: every column, row and supernode of the factor of
/// the graph stands for two. `ordering` is of the nodes; `common.supernodal` says which kind. Free
/// it with cholmod_free_factor(). Throws std::bad_alloc.
cholmod_factor* symbolic_factor(const SparseSymmetric& matrix, std::vector<int>& ordering,
                                cholmod_common& common);

/// A view of the graph of the nodes as the pattern of a CHOLMOD matrix, strictly lower triangle.
cholmod_sparse view_of_graph(const SparseSymmetric& matrix);

}  // namespace foldless
