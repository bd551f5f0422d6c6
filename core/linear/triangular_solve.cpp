// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/triangular_solve.h"

#include "core/linear/sweep.h"

namespace foldless {
namespace {

using Pair = Eigen::Map<Eigen::Vector2d>;
using ConstPair = Eigen::Map<const Eigen::Vector2d>;

/// A supernode with its values.
struct Panel {
  int first;            ///< column of L
  int columns;          ///< an even number
  int rows_count;       ///< the first of which are the columns
  const int* below;     ///< nodes in the rows below
  const double* value;  ///< rows_count × columns

  Panel(const SymbolicFactor& factor, const double* values, const Supernode& s)
      : first(s.first),
        columns(s.columns),
        rows_count(s.rows()),
        below(factor.solve_rows.data() + s.row_start),
        value(values + s.value_start) {}
};

/// x becomes L⁻¹ x.
void forward(const Panel& s, double* x, double* work) {
  for (int i = 0; i < s.columns; ++i) work[i] = x[s.first + i];
  for (int i = s.columns; i < s.rows_count; ++i) work[i] = 0;
  for (int j = 0; j < s.columns; j += 2) {
    const double* a = s.value + static_cast<std::ptrdiff_t>(j) * s.rows_count;
    const double* b = a + s.rows_count;
    const double xa = work[j] * a[j];
    const double xb = (work[j + 1] - a[j + 1] * xa) * b[j + 1];
    x[s.first + j] = xa;
    x[s.first + j + 1] = xb;
    for (int i = j + 2; i < s.rows_count; ++i) work[i] -= a[i] * xa + b[i] * xb;
  }
  const int* node = s.below;
  for (int i = s.columns; i < s.rows_count; i += 2, ++node)
    Pair(x + 2 * *node) += ConstPair(work + i);
}

/// x becomes L⁻ᵀ x.
void backward(const Panel& s, double* x, double* work) {
  const int* node = s.below;
  for (int i = s.columns; i < s.rows_count; i += 2, ++node)
    Pair(work + i) = ConstPair(x + 2 * *node);
  for (int j = s.columns - 2; j >= 0; j -= 2) {
    const double* a = s.value + static_cast<std::ptrdiff_t>(j) * s.rows_count;
    const double* b = a + s.rows_count;
    const Eigen::Index below = s.rows_count - j - 2;
    const Eigen::Map<const Eigen::VectorXd> known(work + j + 2, below);
    const double sum_a = Eigen::Map<const Eigen::VectorXd>(a + j + 2, below).dot(known);
    const double sum_b = Eigen::Map<const Eigen::VectorXd>(b + j + 2, below).dot(known);
    work[j + 1] = (x[s.first + j + 1] - sum_b) * b[j + 1];
    work[j] = (x[s.first + j] - sum_a - a[j + 1] * work[j + 1]) * a[j];
    x[s.first + j] = work[j];
    x[s.first + j + 1] = work[j + 1];
  }
}

}  // namespace

void triangular_solve(const SymbolicFactor& factor, const double* values, Eigen::VectorXd& x,
                      Eigen::VectorXd& work) {
  work.resize(static_cast<Eigen::Index>(sweep_work_size(factor, 0)));
  const auto step_forward = [&](const Supernode& s, double* at, double* scratch) {
    forward({factor, values, s}, at, scratch);
  };
  const auto step_backward = [&](const Supernode& s, double* at, double* scratch) {
    backward({factor, values, s}, at, scratch);
  };
  sweep(factor, SweptVector<double>{x.data(), work.data()}, step_forward, step_backward);
}

}  // namespace foldless
