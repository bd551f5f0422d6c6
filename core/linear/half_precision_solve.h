// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/linear/buffer.h"
#include "core/linear/symbolic_factor.h"

namespace foldless {

/// L D Lᵀ with ones on the diagonal of L, whose other values are in half precision: eleven binary
/// digits, half of what the memory has to bring of single precision.
///
/// Columns of a supernode go by fours, and a last two, in *strips*: of each column eight rows below
/// the four, then the next eight rows, zero where there are no more.
struct HalfFactor {
  Buffer<std::uint16_t> strips;
  std::vector<std::size_t> start;  ///< where the strips of each supernode begin
  /// Four values a column: the inverse of its D, and what L has in the next columns of the four.
  Buffer<float> heads;
};

/// Rounds the values that factorize() in multifrontal.h makes in single precision. Precondition:
/// solves_in_single_precision(), also of the next function.
void to_half_precision(const SymbolicFactor& factor, const float* single, HalfFactor& half);

/// Solves L D Lᵀ x = b in place as triangular_solve_single() does, with as much room.
void triangular_solve_half(const SymbolicFactor& factor, const HalfFactor& half, float* x,
                           float* work);

}  // namespace foldless
