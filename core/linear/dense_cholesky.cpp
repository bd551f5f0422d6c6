// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/dense_cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/threads/team.h"

namespace foldless {
namespace {

/// Columns whose products are taken together: with some hundred rows they stay in the cache.
constexpr int kTogether = 64;
constexpr int kStrip = 4;

/// The Cholesky factor of the lower triangle of `size` columns at `a`, inverse on the diagonal;
/// returns `size`, or the first column whose pivot is not positive or too large.
template <class Value>
int factorize_corner(Value* a, int stride, int size) {
  for (int j = 0; j < size; ++j) {
    Value* column = a + static_cast<std::ptrdiff_t>(j) * stride;
    if (!(column[j] > 0 && column[j] <= std::numeric_limits<Value>::max())) return j;
    const Value inverse = 1 / std::sqrt(column[j]);
    column[j] = inverse;
    for (int i = j + 1; i < size; ++i) column[i] *= inverse;
    for (int k = j + 1; k < size; ++k) {
      Value* other = a + static_cast<std::ptrdiff_t>(k) * stride;
      for (int i = k; i < size; ++i) other[i] -= column[i] * column[k];
    }
  }
  return size;
}

struct Columns {
  int begin, end;
};

/// Rows of a panel.
struct Rows {
  int begin, end;
};

/// What the columns `done` take off the columns from j on, in some rows.
template <class Value>
ColumnStrip<Value> strip_of(const DensePanel<Value>& p, Columns done, Columns j, Rows rows) {
  const std::ptrdiff_t stride = p.rows;
  const Value* left = p.value + done.begin * stride;
  return {p.value + j.begin * stride + rows.begin,
          p.rows,
          left + rows.begin,
          left + j.begin,
          p.rows,
          done.end - done.begin,
          rows.end - rows.begin,
          j.end - j.begin};
}

/// Calls visit(columns) for strips of `columns`.
template <class Visit>
void for_strips(Columns columns, const Visit& visit) {
  for (int j = columns.begin; j < columns.end; j += kStrip)
    if (!visit(Columns{j, std::min(j + kStrip, columns.end)})) return;
}

/// Factorizes some columns of a panel, from which all before them were subtracted, in the rows up
/// to `end`.
template <class Value>
int factorize_columns(const DensePanel<Value>& p, Columns columns, int end,
                      const DenseKernels<Value>& kernels) {
  int found = columns.end;
  for_strips(columns, [&](Columns j) {
    const Columns done{columns.begin, j.begin};
    const ColumnStrip<Value> corner = strip_of(p, done, j, {j.begin, j.end});
    if (corner.terms > 0) kernels.subtract(corner);
    const int width = factorize_corner(corner.target, p.rows, corner.columns);
    if (width < corner.columns) {
      found = j.begin + width;
      return false;
    }
    kernels.subtract_and_solve(strip_of(p, done, j, {j.end, end}), corner.target);
    return true;
  });
  return found;
}

/// The rest of factorize_columns() in other rows below.
template <class Value>
void solve_rows(const DensePanel<Value>& p, Columns columns, Rows rows,
                const DenseKernels<Value>& kernels) {
  for_strips(columns, [&](Columns j) {
    const Value* triangle = p.value + static_cast<std::ptrdiff_t>(j.begin) * (p.rows + 1);
    kernels.subtract_and_solve(strip_of(p, {columns.begin, j.begin}, j, rows), triangle);
    return true;
  });
}

/// Of things of so many multiplications each, how many are worth handing out together.
std::ptrdiff_t grain(std::ptrdiff_t multiplications) {
  constexpr std::ptrdiff_t kWorth = 100000;  // some ten microseconds
  return 1 + kWorth / std::max<std::ptrdiff_t>(multiplications, 1);
}

}  // namespace

template <class Value>
int factorize_panel(const DensePanel<Value>& p, const DenseKernels<Value>& kernels) {
  for (int begin = 0; begin < p.columns; begin += kTogether) {
    const Columns columns{begin, std::min(begin + kTogether, p.columns)};
    const int width = columns.end - columns.begin, below = p.rows - columns.end;
    const std::ptrdiff_t rows = 12 * grain(static_cast<std::ptrdiff_t>(6) * width * width);
    const bool is_shared = present_team() && below > rows;
    const int found = factorize_columns(p, columns, is_shared ? columns.end : p.rows, kernels);
    if (found < columns.end) return found;
    if (is_shared)
      in_ranges(below, rows, [&](std::ptrdiff_t first, std::ptrdiff_t end) {
        solve_rows(p, columns,
                   {columns.end + static_cast<int>(first), columns.end + static_cast<int>(end)},
                   kernels);
      });
    const std::ptrdiff_t strips = (p.columns - columns.end + kStrip - 1) / kStrip;
    in_ranges(strips, grain(static_cast<std::ptrdiff_t>(kStrip) * width * below),
              [&](std::ptrdiff_t first, std::ptrdiff_t end) {
                const int from = columns.end + kStrip * static_cast<int>(first);
                const int to = std::min(columns.end + kStrip * static_cast<int>(end), p.columns);
                for_strips({from, to}, [&](Columns j) {
                  kernels.subtract(strip_of(p, columns, j, {j.begin, p.rows}));
                  return true;
                });
              });
  }
  return p.columns;
}

template <class Value>
void subtract_square(const DensePanel<Value>& p, Value* U, Square start,
                     const DenseKernels<Value>& kernels) {
  const int below = p.rows - p.columns;
  const auto subtract_from = [&](Columns columns) {
    for (int begin = 0; begin < p.columns; begin += kTogether) {
      const int terms = std::min(kTogether, p.columns - begin);
      const auto take =
          start == Square::from_zero && begin == 0 ? kernels.set_negative : kernels.subtract;
      for_strips(columns, [&](Columns j) {
        const Value* left =
            p.value + static_cast<std::ptrdiff_t>(begin) * p.rows + p.columns + j.begin;
        take({U + static_cast<std::ptrdiff_t>(j.begin) * (below + 1), below, left, left, p.rows,
              terms, below - j.begin, j.end - j.begin});
        return true;
      });
    }
  };
  const std::ptrdiff_t strips = (below + kStrip - 1) / kStrip;
  in_ranges(strips, grain(static_cast<std::ptrdiff_t>(kStrip) * p.columns * below / 2),
            [&](std::ptrdiff_t first, std::ptrdiff_t end) {
              subtract_from({kStrip * static_cast<int>(first),
                             std::min(kStrip * static_cast<int>(end), below)});
            });
}

template int factorize_panel(const DensePanel<double>&, const DenseKernels<double>&);
template int factorize_panel(const DensePanel<float>&, const DenseKernels<float>&);
template void subtract_square(const DensePanel<double>&, double*, Square,
                              const DenseKernels<double>&);
template void subtract_square(const DensePanel<float>&, float*, Square, const DenseKernels<float>&);

}  // namespace foldless
