// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/triangular_solve.h"

namespace foldless {
namespace {

/// The columns of L from `first` on, one below the other with their rows.
struct Supernode {
  int first;            ///< column of L
  int columns;          ///< an even number
  int rows_count;       ///< the first of which are the columns
  const int* rows;      ///< of L
  const double* value;  ///< rows_count × columns

  Supernode(const cholmod_factor& factor, std::size_t k) {
    const auto* super = static_cast<const int*>(factor.super);
    const auto* row_start = static_cast<const int*>(factor.pi);
    first = super[k];
    columns = super[k + 1] - first;
    rows_count = row_start[k + 1] - row_start[k];
    rows = static_cast<const int*>(factor.s) + row_start[k];
    value = static_cast<const double*>(factor.x) + static_cast<const int*>(factor.px)[k];
  }
};

/// x becomes L⁻¹ x.
void forward(const Supernode& s, double* x, double* work) {
  for (int i = 0; i < s.columns; ++i) work[i] = x[s.first + i];
  for (int i = s.columns; i < s.rows_count; ++i) work[i] = 0;
  for (int j = 0; j < s.columns; j += 2) {
    const double* a = s.value + static_cast<std::ptrdiff_t>(j) * s.rows_count;
    const double* b = a + s.rows_count;
    const double xa = work[j] / a[j];
    const double xb = (work[j + 1] - a[j + 1] * xa) / b[j + 1];
    x[s.first + j] = xa;
    x[s.first + j + 1] = xb;
    for (int i = j + 2; i < s.rows_count; ++i) work[i] -= a[i] * xa + b[i] * xb;
  }
  for (int i = s.columns; i < s.rows_count; ++i) x[s.rows[i]] += work[i];
}

/// x becomes L⁻ᵀ x.
void backward(const Supernode& s, double* x, double* work) {
  for (int i = s.columns; i < s.rows_count; ++i) work[i] = x[s.rows[i]];
  for (int j = s.columns - 2; j >= 0; j -= 2) {
    const double* a = s.value + static_cast<std::ptrdiff_t>(j) * s.rows_count;
    const double* b = a + s.rows_count;
    const Eigen::Index below = s.rows_count - j - 2;
    const Eigen::Map<const Eigen::VectorXd> known(work + j + 2, below);
    const double sum_a = Eigen::Map<const Eigen::VectorXd>(a + j + 2, below).dot(known);
    const double sum_b = Eigen::Map<const Eigen::VectorXd>(b + j + 2, below).dot(known);
    work[j + 1] = (x[s.first + j + 1] - sum_b) / b[j + 1];
    work[j] = (x[s.first + j] - sum_a - a[j + 1] * work[j + 1]) / a[j];
    x[s.first + j] = work[j];
    x[s.first + j + 1] = work[j + 1];
  }
}

using Pair = Eigen::Map<Eigen::Vector2d>;
using ConstPair = Eigen::Map<const Eigen::Vector2d>;

/// Two columns of L of a simplicial factor, the second of which lacks the first row.
struct ColumnPair {
  int first;        ///< column of L
  int below;        ///< rows below the two, an even number
  const int* rows;  ///< those; every other one is one more than that before it
  const double *a, *b;
  double inverse_a, inverse_b;  ///< of the diagonal: nothing waits for these divisions

  ColumnPair(const cholmod_factor& factor, int column) : first(column) {
    const auto* start = static_cast<const int*>(factor.p);
    const auto* value = static_cast<const double*>(factor.x);
    below = static_cast<const int*>(factor.nz)[column] - 2;
    rows = static_cast<const int*>(factor.i) + start[column] + 2;
    a = value + start[column];
    b = value + start[column + 1];
    inverse_a = 1 / a[0];
    inverse_b = 1 / b[0];
  }
};

/// x becomes L⁻¹ x.
void forward(const ColumnPair& s, double* x) {
  const double xa = x[s.first] * s.inverse_a;
  const double xb = (x[s.first + 1] - s.a[1] * xa) * s.inverse_b;
  Pair(x + s.first) << xa, xb;
  const double *a = s.a + 2, *b = s.b + 1;
  for (int i = 0; i < s.below; i += 2)
    Pair(x + s.rows[i]) -= xa * ConstPair(a + i) + xb * ConstPair(b + i);
}

/// x becomes L⁻ᵀ x.
void backward(const ColumnPair& s, double* x) {
  const double *a = s.a + 2, *b = s.b + 1;
  Eigen::Vector2d sum_a(0, 0), sum_b(0, 0);
  for (int i = 0; i < s.below; i += 2) {
    const ConstPair known(x + s.rows[i]);
    sum_a += known.cwiseProduct(ConstPair(a + i));
    sum_b += known.cwiseProduct(ConstPair(b + i));
  }
  const double xb = (x[s.first + 1] - sum_b.sum()) * s.inverse_b;
  const double xa = (x[s.first] - sum_a.sum() - s.a[1] * xb) * s.inverse_a;
  Pair(x + s.first) << xa, xb;
}

}  // namespace

void triangular_solve(const cholmod_factor& factor, Eigen::VectorXd& x, Eigen::VectorXd& work) {
  if (!factor.is_super) {
    const int n = static_cast<int>(factor.n);
    for (int j = 0; j < n; j += 2) forward({factor, j}, x.data());
    for (int j = n; j > 0; j -= 2) backward({factor, j - 2}, x.data());
    return;
  }
  work.resize(static_cast<Eigen::Index>(factor.n));
  for (std::size_t k = 0; k < factor.nsuper; ++k) forward({factor, k}, x.data(), work.data());
  for (std::size_t k = factor.nsuper; k-- > 0;) backward({factor, k}, x.data(), work.data());
}

}  // namespace foldless
