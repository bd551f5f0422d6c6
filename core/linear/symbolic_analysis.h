// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/linear/elimination_tree.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Of fewer multiplications, some tenths of a millisecond, the parts would be too small to hand
/// out.
constexpr double kPartedFrom = 4e6;

/// A factorization of `parted_from` multiplications or more is parted into subtrees. Throws Error
/// where a panel has more than 2³¹ values.
SymbolicFactor symbolic_factor(EliminationTree tree, double parted_from = kPartedFrom);

}  // namespace foldless
