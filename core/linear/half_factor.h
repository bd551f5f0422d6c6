// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

constexpr int kStripRows = 8;
constexpr int kStripColumns = 4;

/// How many columns of a supernode go together from this one on.
inline int strip_columns(const Supernode& s, int column) {
  return std::min(kStripColumns, s.columns - column);
}

/// Values in the strips of so many columns that go together, with so many rows below them.
inline std::size_t strip_values(int columns, int below) {
  return static_cast<std::size_t>(columns) *
         static_cast<std::size_t>((below + kStripRows - 1) / kStripRows * kStripRows);
}

/// The number of one of the factor's own supernodes.
inline std::ptrdiff_t number_in(const SymbolicFactor& factor, const Supernode& s) {
  return &s - factor.supernodes.data();
}

/// Room for all supernodes; what was in it is lost. Throws std::bad_alloc.
void make_room(const SymbolicFactor& factor, HalfFactor& half);

/// Rounds the panel of a supernode of `factor`, in single precision as factorize_panel() leaves it.
/// Shared by the team of this thread where it is large. Precondition: solves_in_single_precision().
void round_panel(const SymbolicFactor& factor, const Supernode& s, const float* panel,
                 HalfFactor& half);

}  // namespace foldless
