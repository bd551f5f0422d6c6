// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/linear/dense_kernels.h"

// Before it is included FOLDLESS_KERNEL says for which processors its functions are compiled, where
// that is not for all. Everything in here is the including file's own: two of them do not share it.
#ifndef FOLDLESS_KERNEL
#define FOLDLESS_KERNEL inline
#endif

namespace foldless {
namespace {

/// What is known of a strip when it is compiled.
enum class StripKind { subtract, set_negative, solve };

/// A strip, and the triangle of DenseKernels::subtract_and_solve() where it has one.
template <class Value>
struct StripAndTriangle {
  const ColumnStrip<Value>& strip;
  const Value* triangle;
};

/// Which values of a tile's last register count, where all of them do.
struct AllRows {};

template <class Lane, int Lanes, class Last>
FOLDLESS_KERNEL Lane load_lane(const typename Lane::Value* tile, int r, Last last) {
  return r + 1 < Lanes ? Lane::load(tile + r * Lane::kRows, AllRows{})
                       : Lane::load(tile + r * Lane::kRows, last);
}

/// Lanes registers of rows × Columns from row `i` on, of the last of which `last` says what counts.
/// A Lane is a register of kRows Values. Every value goes through the same operations in the same
/// order whatever the tile that it lies in.
template <class Lane, int Lanes, int Columns, StripKind Kind, class Last>
FOLDLESS_KERNEL void do_tile(const StripAndTriangle<typename Lane::Value>& t, int i, Last last) {
  using Value = typename Lane::Value;
  const ColumnStrip<Value>& s = t.strip;
  Lane value[Columns][Lanes];
  Value* target = s.target + i;
  for (int c = 0; c < Columns; ++c) {
    const Value* from = target + static_cast<std::ptrdiff_t>(c) * s.target_stride;
    for (int r = 0; r < Lanes; ++r)
      value[c][r] =
          Kind == StripKind::set_negative ? Lane::zero() : load_lane<Lane, Lanes>(from, r, last);
  }
  const Value* left = s.left + i;
  const Value* right = s.right;
  for (int k = 0; k < s.terms; ++k, left += s.stride, right += s.stride) {
    Lane rows[Lanes];
    for (int r = 0; r < Lanes; ++r) rows[r] = load_lane<Lane, Lanes>(left, r, last);
    for (int c = 0; c < Columns; ++c) {
      const Lane factor = Lane::all(right + c);
      for (int r = 0; r < Lanes; ++r) value[c][r].subtract(rows[r], factor);
    }
  }
  if constexpr (Kind == StripKind::solve)
    for (int c = 0; c < Columns; ++c) {
      const Value* column = t.triangle + static_cast<std::ptrdiff_t>(c) * s.target_stride;
      for (int r = 0; r < Lanes; ++r) value[c][r].multiply(Lane::all(column + c));
      for (int d = c + 1; d < Columns; ++d)
        for (int r = 0; r < Lanes; ++r) value[d][r].subtract(value[c][r], Lane::all(column + d));
    }
  for (int c = 0; c < Columns; ++c, target += s.target_stride) {
    for (int r = 0; r + 1 < Lanes; ++r) value[c][r].store(target + r * Lane::kRows, AllRows{});
    value[c][Lanes - 1].store(target + (Lanes - 1) * Lane::kRows, last);
  }
}

}  // namespace
}  // namespace foldless
