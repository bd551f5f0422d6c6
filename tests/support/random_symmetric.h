// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "core/linear/sparse_symmetric.h"
#include "tests/support/dense_matrix.h"

namespace foldless::test {

/// Random blocks on the edges of a graph: random edges between near and far nodes, some nodes with
/// none, several parts.
inline SparseSymmetric random_symmetric(unsigned seed) {
  std::mt19937 random(seed);
  const auto below = [&random](int end) {
    return std::uniform_int_distribution(0, end - 1)(random);
  };
  const int nodes = 1 + below(seed % 3 == 0 ? 12 : 400);
  const int reach = 1 + below(seed % 5 == 0 ? nodes : 20);
  std::vector<std::pair<int, int>> edges;
  for (int k = below(4 * nodes); k > 0; --k) {
    const int a = below(nodes), b = std::min(nodes - 1, a + below(reach));
    if (a != b) edges.emplace_back(a, b);
  }
  SparseSymmetric m = sparse_symmetric(nodes, edges);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (double& value : m.value) value = unit(random);
  return m;
}

/// The matrix with as much on its diagonal as its rows have beside it, and more.
inline SparseSymmetric dominated(SparseSymmetric m, unsigned seed) {
  const Eigen::VectorXd sums = dense(m).cwiseAbs().rowwise().sum();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> more(0.01, 2);
  for (int i = 0; i < m.size(); ++i) diagonal(m, i) = sums[i] + more(random);
  return m;
}

}  // namespace foldless::test
