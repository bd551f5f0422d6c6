// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Parts the supernodes of a factor into subtrees that are worked on at the same time and the top
/// that comes after them. It is the same plan for any number of threads, and so are the bits of
/// what is computed by it. Less than `parted_from` multiplications are all top. Precondition:
/// supernodes are known and linked.
void find_subtrees(SymbolicFactor& factor, double parted_from);

/// Gives every row above a subtree its outer place, and every update matrix its own. Precondition:
/// all else of the factor is known.
void plan_work(SymbolicFactor& factor);

}  // namespace foldless
