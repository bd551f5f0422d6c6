// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foldless {
namespace {

/// Columns whose products are taken together: with some hundred rows they stay in the cache.
constexpr int kTogether = 64;
constexpr int kStrip = 4;

/// The Cholesky factor of the lower triangle of `size` columns at `a`, inverse on the diagonal;
/// returns `size`, or the first column whose pivot is not positive.
int factorize_corner(double* a, int stride, int size) {
  for (int j = 0; j < size; ++j) {
    double* column = a + static_cast<std::ptrdiff_t>(j) * stride;
    if (!(column[j] > 0)) return j;
    const double inverse = 1 / std::sqrt(column[j]);
    column[j] = inverse;
    for (int i = j + 1; i < size; ++i) column[i] *= inverse;
    for (int k = j + 1; k < size; ++k) {
      double* other = a + static_cast<std::ptrdiff_t>(k) * stride;
      for (int i = k; i < size; ++i) other[i] -= column[i] * column[k];
    }
  }
  return size;
}

struct Columns {
  int begin, end;
};

/// What the columns `done` take off the columns from j on, from row j down.
ColumnStrip strip_of(const DensePanel& p, Columns done, int j, int width) {
  const std::ptrdiff_t stride = p.rows;
  const double* left = p.value + done.begin * stride + j;
  return {p.value + j * stride + j, p.rows,     left, left, p.rows,
          done.end - done.begin,    p.rows - j, width};
}

/// Factorizes some columns of a panel, from which all before them were subtracted.
int factorize_columns(const DensePanel& p, Columns columns, const DenseKernels& kernels) {
  for (int j = columns.begin; j < columns.end; j += kStrip) {
    const int width = std::min(kStrip, columns.end - j);
    const ColumnStrip strip = strip_of(p, {columns.begin, j}, j, width);
    ColumnStrip corner = strip;
    corner.rows = width;
    if (strip.terms > 0) kernels.subtract(corner);
    const int found = factorize_corner(strip.target, p.rows, width);
    if (found < width) return j + found;
    ColumnStrip below = strip;
    below.target += width;
    below.left += width;
    below.rows -= width;
    kernels.subtract_and_solve(below, strip.target);
  }
  return columns.end;
}

}  // namespace

int factorize_panel(const DensePanel& p, const DenseKernels& kernels) {
  for (int begin = 0; begin < p.columns; begin += kTogether) {
    const Columns columns{begin, std::min(begin + kTogether, p.columns)};
    const int found = factorize_columns(p, columns, kernels);
    if (found < columns.end) return found;
    for (int j = columns.end; j < p.columns; j += kStrip)
      kernels.subtract(strip_of(p, columns, j, std::min(kStrip, p.columns - j)));
  }
  return p.columns;
}

void subtract_square(const DensePanel& p, double* U, Square start, const DenseKernels& kernels) {
  const int below = p.rows - p.columns;
  for (int begin = 0; begin < p.columns; begin += kTogether) {
    const int terms = std::min(kTogether, p.columns - begin);
    const auto take =
        start == Square::from_zero && begin == 0 ? kernels.set_negative : kernels.subtract;
    for (int j = 0; j < below; j += kStrip) {
      const double* left = p.value + static_cast<std::ptrdiff_t>(begin) * p.rows + p.columns + j;
      take({U + static_cast<std::ptrdiff_t>(j) * below + j, below, left, left, p.rows, terms,
            below - j, std::min(kStrip, below - j)});
    }
  }
}

}  // namespace foldless
