// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// An order of the nodes of a matrix that was made for another one, whose graph differs by few
/// edges: `order` is a postorder of the elimination tree that `parent` tells by places (−1 at a
/// root). Two nodes that have become neighbours with no path up the tree between them would merge
/// all that is above them up to where their paths meet; one of them is eliminated there instead,
/// as nodes of a separator are [Geo73].
std::vector<int> repaired_ordering(const SparseSymmetric& matrix, const std::vector<int>& order,
                                   const std::vector<int>& parent);

}  // namespace foldless
