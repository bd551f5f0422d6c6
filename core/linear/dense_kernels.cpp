// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#include <cstddef>
#include <initializer_list>

namespace foldless {
namespace {

enum class TileStart { target, zero };

/// Rows × Columns values of a strip, from row `i` on, that stay in registers.
template <class Value, int Rows, int Columns, TileStart Start>
struct PlainTile {
  Value value[Columns][Rows];

  PlainTile(const ColumnStrip<Value>& s, int i) {
    for (int c = 0; c < Columns; ++c)
      for (int r = 0; r < Rows; ++r)
        value[c][r] = Start == TileStart::zero
                          ? 0
                          : s.target[static_cast<std::ptrdiff_t>(c) * s.target_stride + i + r];
    const Value* left = s.left + i;
    const Value* right = s.right;
    for (int k = 0; k < s.terms; ++k, left += s.stride, right += s.stride)
      for (int c = 0; c < Columns; ++c)
        for (int r = 0; r < Rows; ++r) value[c][r] -= left[r] * right[c];
  }
  void solve(const Value* triangle, int stride) {
    for (int c = 0; c < Columns; ++c) {
      const Value* column = triangle + static_cast<std::ptrdiff_t>(c) * stride;
      for (int r = 0; r < Rows; ++r) value[c][r] *= column[c];
      for (int d = c + 1; d < Columns; ++d)
        for (int r = 0; r < Rows; ++r) value[d][r] -= column[d] * value[c][r];
    }
  }
  void store(const ColumnStrip<Value>& s, int i) const {
    for (int c = 0; c < Columns; ++c)
      for (int r = 0; r < Rows; ++r)
        s.target[static_cast<std::ptrdiff_t>(c) * s.target_stride + i + r] = value[c][r];
  }
};

template <int Columns, TileStart Start, class Value>
void plain_strip(const ColumnStrip<Value>& s, const Value* triangle) {
  int i = 0;
  for (; i + 4 <= s.rows; i += 4) {
    PlainTile<Value, 4, Columns, Start> tile(s, i);
    if (triangle) tile.solve(triangle, s.target_stride);
    tile.store(s, i);
  }
  if (i == s.rows) return;
  PlainTile<Value, 2, Columns, Start> tile(s, i);
  if (triangle) tile.solve(triangle, s.target_stride);
  tile.store(s, i);
}

template <TileStart Start, class Value>
void plain_strip(const ColumnStrip<Value>& s, const Value* triangle) {
  if (s.columns == 4)
    plain_strip<4, Start, Value>(s, triangle);
  else
    plain_strip<2, Start, Value>(s, triangle);
}

template <class Value>
void plain_subtract(const ColumnStrip<Value>& s) {
  plain_strip<TileStart::target, Value>(s, nullptr);
}
template <class Value>
void plain_set_negative(const ColumnStrip<Value>& s) {
  plain_strip<TileStart::zero, Value>(s, nullptr);
}
template <class Value>
void plain_subtract_and_solve(const ColumnStrip<Value>& s, const Value* triangle) {
  plain_strip<TileStart::target, Value>(s, triangle);
}

}  // namespace

template <class Value>
const DenseKernels<Value>& plain_kernels() {
  static constexpr DenseKernels<Value> kKernels = {
      "plain", plain_subtract<Value>, plain_set_negative<Value>, plain_subtract_and_solve<Value>};
  return kKernels;
}

template <class Value>
const DenseKernels<Value>& dense_kernels() {
  static const DenseKernels<Value>& best = []() -> const DenseKernels<Value>& {
    for (const DenseKernels<Value>* kernels :
         {avx512_kernels<Value>(), avx2_kernels<Value>(), neon_kernels<Value>()})
      if (kernels) return *kernels;
    return plain_kernels<Value>();
  }();
  return best;
}

template const DenseKernels<double>& plain_kernels();
template const DenseKernels<float>& plain_kernels();
template const DenseKernels<double>& dense_kernels();
template const DenseKernels<float>& dense_kernels();

}  // namespace foldless
