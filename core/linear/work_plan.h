// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Parts the supernodes of a factor into subtrees that are worked on at the same time and the top
/// that comes after them, and gives every update matrix its place. It is the same plan for any
/// number of threads, and so are the bits of what is computed by it. Less than `parted_from`
/// multiplications are all top. Precondition: all else of the factor is known.
void plan_work(SymbolicFactor& factor, double parted_from);

}  // namespace foldless
