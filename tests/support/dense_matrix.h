// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/linear/sparse_symmetric.h"

namespace foldless::test {

/// Calls visit(row, column, value) for every entry of the lower triangle, by columns.
template <class Visit>
void for_each_entry(const SparseSymmetric& m, const Visit& visit) {
  std::size_t k = 0;
  for (int j = 0; j < m.nodes; ++j)
    for (const int column : {2 * j, 2 * j + 1}) {
      for (int row = column; row < 2 * j + 2; ++row) visit(row, column, m.value[k++]);
      for (int i = m.graph_start[static_cast<std::size_t>(j)];
           i < m.graph_start[static_cast<std::size_t>(j) + 1]; ++i)
        for (const int row : {0, 1})
          visit(2 * m.graph[static_cast<std::size_t>(i)] + row, column, m.value[k++]);
    }
}

/// The whole matrix.
inline Eigen::MatrixXd dense(const SparseSymmetric& m) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m.size(), m.size());
  for_each_entry(m, [&](int row, int column, double value) {
    result(row, column) = result(column, row) = value;
  });
  return result;
}

/// Of unknown i.
inline double& diagonal(SparseSymmetric& m, int i) {
  const auto node = static_cast<std::size_t>(i / 2);
  return m
      .value[static_cast<std::size_t>(i % 2 == 0 ? m.first_column(node) : m.second_column(node))];
}

/// Of a symmetric matrix.
inline double smallest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()[0];
}

}  // namespace foldless::test
