// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/linear/half_factor.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// Solves L D Lᵀ x = b in place as triangular_solve_single() does, with as much room.
/// Precondition: solves_in_single_precision().
void triangular_solve_half(const SymbolicFactor& factor, const HalfFactor& half, float* x,
                           float* work);

}  // namespace foldless
