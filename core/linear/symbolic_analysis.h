// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Of fewer multiplications, some tenths of a millisecond, the parts would be too small to hand
/// out.
constexpr double kPartedFrom = 4e6;

/// `order` is a fill-reducing one of the nodes; an equivalent one is used. A factorization of
/// `parted_from` multiplications or more is parted into subtrees. Throws Error where a panel has
/// more than 2³¹ values.
SymbolicFactor symbolic_factor(const SparseSymmetric& matrix, const std::vector<int>& order,
                               double parted_from = kPartedFrom);

}  // namespace foldless
