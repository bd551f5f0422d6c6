// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/supernodal_solve.h"

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

}  // namespace

void supernodal_solve(const cholmod_factor& factor, Eigen::VectorXd& x, Eigen::VectorXd& work) {
  work.resize(static_cast<Eigen::Index>(factor.n));
  for (std::size_t k = 0; k < factor.nsuper; ++k) forward({factor, k}, x.data(), work.data());
  for (std::size_t k = factor.nsuper; k-- > 0;) backward({factor, k}, x.data(), work.data());
}

}  // namespace foldless
