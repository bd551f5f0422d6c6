// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_kernels.h"

#include <cstddef>
#include <initializer_list>

namespace foldless {
namespace {

enum class TileStart { target, zero };

/// Rows × Columns values of a strip, from row `i` on, that stay in registers.
template <int Rows, int Columns, TileStart Start>
struct PlainTile {
  double value[Columns][Rows];

  PlainTile(const ColumnStrip& s, int i) {
    for (int c = 0; c < Columns; ++c)
      for (int r = 0; r < Rows; ++r)
        value[c][r] = Start == TileStart::zero
                          ? 0
                          : s.target[static_cast<std::ptrdiff_t>(c) * s.target_stride + i + r];
    const double* left = s.left + i;
    const double* right = s.right;
    for (int k = 0; k < s.terms; ++k, left += s.stride, right += s.stride)
      for (int c = 0; c < Columns; ++c)
        for (int r = 0; r < Rows; ++r) value[c][r] -= left[r] * right[c];
  }
  void solve(const double* triangle, int stride) {
    for (int c = 0; c < Columns; ++c) {
      const double* column = triangle + static_cast<std::ptrdiff_t>(c) * stride;
      for (int r = 0; r < Rows; ++r) value[c][r] *= column[c];
      for (int d = c + 1; d < Columns; ++d)
        for (int r = 0; r < Rows; ++r) value[d][r] -= column[d] * value[c][r];
    }
  }
  void store(const ColumnStrip& s, int i) const {
    for (int c = 0; c < Columns; ++c)
      for (int r = 0; r < Rows; ++r)
        s.target[static_cast<std::ptrdiff_t>(c) * s.target_stride + i + r] = value[c][r];
  }
};

template <int Columns, TileStart Start>
void plain_strip(const ColumnStrip& s, const double* triangle) {
  int i = 0;
  for (; i + 4 <= s.rows; i += 4) {
    PlainTile<4, Columns, Start> tile(s, i);
    if (triangle) tile.solve(triangle, s.target_stride);
    tile.store(s, i);
  }
  if (i == s.rows) return;
  PlainTile<2, Columns, Start> tile(s, i);
  if (triangle) tile.solve(triangle, s.target_stride);
  tile.store(s, i);
}

template <TileStart Start>
void plain_strip(const ColumnStrip& s, const double* triangle) {
  if (s.columns == 4)
    plain_strip<4, Start>(s, triangle);
  else
    plain_strip<2, Start>(s, triangle);
}

void plain_subtract(const ColumnStrip& s) { plain_strip<TileStart::target>(s, nullptr); }
void plain_set_negative(const ColumnStrip& s) { plain_strip<TileStart::zero>(s, nullptr); }
void plain_subtract_and_solve(const ColumnStrip& s, const double* triangle) {
  plain_strip<TileStart::target>(s, triangle);
}

}  // namespace

const DenseKernels plain_kernels = {"plain", plain_subtract, plain_set_negative,
                                    plain_subtract_and_solve};

const DenseKernels& dense_kernels() {
  static const DenseKernels& best = []() -> const DenseKernels& {
    for (const DenseKernels* kernels : {avx512_kernels(), avx2_kernels(), neon_kernels()})
      if (kernels) return *kernels;
    return plain_kernels;
  }();
  return best;
}

}  // namespace foldless
