// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/local_solve.h"

#include <atomic>
#include <utility>

#include "core/threads/values_of_ranges.h"

namespace foldless {
namespace {

/// Nodes that a thread takes together: some ten microseconds.
constexpr std::ptrdiff_t kNodesScannedTogether = 4096;

/// The block of nodes i ≥ j, whole on the diagonal too.
Eigen::Matrix2d block_of(const SparseSymmetric& A, int i, int j) {
  const auto [first_column, second_column] = find_block(A, i, j);
  const double* first = &A.value[static_cast<std::size_t>(first_column)];
  const double* second = &A.value[static_cast<std::size_t>(second_column)];
  if (i == j) return Eigen::Matrix2d{{first[0], first[1]}, {first[1], second[0]}};
  return Eigen::Matrix2d{{first[0], second[0]}, {first[1], second[1]}};
}

/// The blocks (i, j), i > j, of nodes of which one or both have a place.
std::vector<std::pair<int, int>> pairs_with(const SparseSymmetric& A,
                                            const std::vector<int>& place) {
  return joined_ranges(A.nodes, kNodesScannedTogether,
                       [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                         std::vector<std::pair<int, int>> pairs;
                         for (std::ptrdiff_t j = begin; j < end; ++j) {
                           const auto node = static_cast<std::size_t>(j);
                           for (int k = A.graph_start[node]; k < A.graph_start[node + 1]; ++k) {
                             const int i = A.graph[static_cast<std::size_t>(k)];
                             if (place[node] >= 0 || place[static_cast<std::size_t>(i)] >= 0)
                               pairs.emplace_back(i, static_cast<int>(j));
                           }
                         }
                         return pairs;
                       });
}

}  // namespace

LocalSolve::LocalSolve(const SparseSymmetric& A, const std::vector<int>& nodes) : nodes_(nodes) {
  std::vector<int> place(static_cast<std::size_t>(A.nodes), -1);  // in S
  for (std::size_t s = 0; s < nodes.size(); ++s) {
    place[static_cast<std::size_t>(nodes[s])] = static_cast<int>(s);
    rows_.push_back({static_cast<int>(s), nodes[s], block_of(A, nodes[s], nodes[s])});
  }
  std::vector<std::pair<int, int>> edges;
  for (const auto& [i, j] : pairs_with(A, place)) {
    const int at_i = place[static_cast<std::size_t>(i)], at_j = place[static_cast<std::size_t>(j)];
    if (at_i >= 0) rows_.push_back({at_i, j, block_of(A, i, j)});
    if (at_j >= 0) rows_.push_back({at_j, i, block_of(A, i, j).transpose()});
    if (at_i >= 0 && at_j >= 0) edges.emplace_back(at_i, at_j);
  }
  SparseSymmetric A_SS = sparse_symmetric(static_cast<int>(nodes.size()), edges);
  for (const auto& [row, column, value] : rows_) {
    const int at = place[static_cast<std::size_t>(column)];
    if (at >= 0 && at <= row) add_block(A_SS, row, at, value);
  }
  factor_.analyze_in_order(A_SS);
  factor_.factorize(A_SS);
}

double LocalSolve::correct(Eigen::VectorXd& x, Eigen::VectorXd& r) {
  Eigen::VectorXd at_s(2 * static_cast<Eigen::Index>(nodes_.size()));
  for (std::size_t s = 0; s < nodes_.size(); ++s)
    at_s.segment<2>(2 * static_cast<Eigen::Index>(s)) = r.segment<2>(2 * nodes_[s]);
  const Eigen::VectorXd y = factor_.solve(at_s);
  for (std::size_t s = 0; s < nodes_.size(); ++s)
    x.segment<2>(2 * nodes_[s]) += y.segment<2>(2 * static_cast<Eigen::Index>(s));
  for (const auto& [row, column, value] : rows_)
    r.segment<2>(2 * column) -= value.transpose() * y.segment<2>(2 * row);
  return 0.5 * at_s.dot(y);
}

void LocalSolve::make_conjugate(Eigen::VectorXd& x) {
  Eigen::VectorXd image = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(nodes_.size()));
  for (const auto& [row, column, value] : rows_)
    image.segment<2>(2 * row) += value * x.segment<2>(2 * column);
  const Eigen::VectorXd y = factor_.solve(image);
  for (std::size_t s = 0; s < nodes_.size(); ++s)
    x.segment<2>(2 * nodes_[s]) -= y.segment<2>(2 * static_cast<Eigen::Index>(s));
}

std::vector<int> with_neighbours(const SparseSymmetric& A, const std::vector<int>& nodes) {
  std::vector<char> is_node(static_cast<std::size_t>(A.nodes), 0);
  for (const int node : nodes) is_node[static_cast<std::size_t>(node)] = 1;
  std::vector<char> is_near = is_node;
  const auto mark = [&](std::size_t node) {
    std::atomic_ref(is_near[node]).store(1, std::memory_order_relaxed);
  };
  each_in_ranges(A.nodes, kNodesScannedTogether, [&](std::ptrdiff_t node) {
    const auto j = static_cast<std::size_t>(node);
    for (int k = A.graph_start[j]; k < A.graph_start[j + 1]; ++k) {
      const auto i = static_cast<std::size_t>(A.graph[static_cast<std::size_t>(k)]);
      if (is_node[j]) mark(i);
      if (is_node[i]) mark(j);
    }
  });
  std::vector<int> result;
  for (int node = 0; node < A.nodes; ++node)
    if (is_near[static_cast<std::size_t>(node)]) result.push_back(node);
  return result;
}

}  // namespace foldless
