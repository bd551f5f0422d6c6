// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "core/linear/sparse_symmetric.h"

namespace foldless::test {

/// The whole matrix.
inline Eigen::MatrixXd dense(const SparseSymmetric& m) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(m.size(), m.size());
  for (int column = 0; column < m.size(); ++column)
    for (int k = m.column_start[static_cast<std::size_t>(column)];
         k < m.column_start[static_cast<std::size_t>(column) + 1]; ++k) {
      const int row = m.row[static_cast<std::size_t>(k)];
      result(row, column) = result(column, row) = m.value[static_cast<std::size_t>(k)];
    }
  return result;
}

/// Of a symmetric matrix.
inline double smallest_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()[0];
}

}  // namespace foldless::test
