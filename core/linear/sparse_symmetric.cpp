// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/sparse_symmetric.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/large_pages.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Later neighbours of every node, sorted and without repeats, by counting.
void make_graph(SparseSymmetric& m, const std::vector<std::pair<int, int>>& edges) {
  std::vector<int> start(static_cast<std::size_t>(m.nodes) + 1, 0);
  for (const auto& [a, b] : edges) ++start[static_cast<std::size_t>(std::min(a, b)) + 1];
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<int> later(edges.size());
  std::vector<int> next(start.begin(), start.end() - 1);
  for (const auto& [a, b] : edges)
    later[static_cast<std::size_t>(next[static_cast<std::size_t>(std::min(a, b))]++)] =
        std::max(a, b);

  m.graph_start.assign(1, 0);
  m.graph_start.reserve(start.size());
  m.graph.clear();
  m.graph.reserve(edges.size());
  for (int j = 0; j < m.nodes; ++j) {
    const auto first = later.begin() + start[static_cast<std::size_t>(j)];
    const auto last = later.begin() + start[static_cast<std::size_t>(j) + 1];
    std::sort(first, last);
    m.graph.insert(m.graph.end(), first, std::unique(first, last));
    m.graph_start.push_back(static_cast<int>(m.graph.size()));
  }
}

void make_earlier(SparseSymmetric& m) {
  m.earlier_start.assign(static_cast<std::size_t>(m.nodes) + 1, 0);
  for (const int i : m.graph) ++m.earlier_start[static_cast<std::size_t>(i) + 1];
  std::partial_sum(m.earlier_start.begin(), m.earlier_start.end(), m.earlier_start.begin());
  m.earlier.resize(m.graph.size());
  std::vector<int> next(m.earlier_start.begin(), m.earlier_start.end() - 1);
  for (int j = 0; j < m.nodes; ++j) {
    const auto node = static_cast<std::size_t>(j);
    int first = m.first_column(node) + 2, second = m.second_column(node) + 1;
    for (int k = m.graph_start[node]; k < m.graph_start[node + 1]; ++k, first += 2, second += 2) {
      const auto i = static_cast<std::size_t>(m.graph[static_cast<std::size_t>(k)]);
      m.earlier[static_cast<std::size_t>(next[i]++)] = {j, {first, second}};
    }
  }
}

/// What follows from the graph.
void make_values(SparseSymmetric& m) {
  const auto size = static_cast<std::size_t>(m.first_column(static_cast<std::size_t>(m.nodes)));
  reserve_large_pages(m.value, size);
  m.value.resize(size);
  constexpr std::ptrdiff_t kValuesTogether = 16'384;
  in_ranges(static_cast<std::ptrdiff_t>(size), kValuesTogether,
            [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
              std::fill(m.value.begin() + begin, m.value.begin() + end, 0.0);
            });
  constexpr int kSharedFrom = 1024;
  if (present_team() && m.nodes >= kSharedFrom) make_earlier(m);
}

/// The rows of a node, as multiply() adds them up: those before the node's column, then that.
// NOLINTNEXTLINE(readability-function-size): y = A x of a node
void multiply_rows(const SparseSymmetric& A, std::ptrdiff_t node, const double* x, double* y) {
  const auto j = static_cast<std::size_t>(node);
  double y0 = 0, y1 = 0;
  for (int k = A.earlier_start[j]; k < A.earlier_start[j + 1]; ++k) {
    const auto& [other, place] = A.earlier[static_cast<std::size_t>(k)];
    const double* first = &A.value[static_cast<std::size_t>(place.first_column)];
    const double* second = &A.value[static_cast<std::size_t>(place.second_column)];
    const double* of = x + 2 * static_cast<std::ptrdiff_t>(other);
    y0 += first[0] * of[0] + second[0] * of[1];
    y1 += first[1] * of[0] + second[1] * of[1];
  }
  const double* first = &A.value[static_cast<std::size_t>(A.first_column(j))];
  const double* second = &A.value[static_cast<std::size_t>(A.second_column(j))];
  const double* own = x + 2 * node;
  double z0 = first[0] * own[0] + first[1] * own[1], z1 = first[1] * own[0] + second[0] * own[1];
  first += 2;
  second += 1;
  for (int k = A.graph_start[j]; k < A.graph_start[j + 1]; ++k, first += 2, second += 2) {
    const double* of = x + 2 * static_cast<std::ptrdiff_t>(A.graph[static_cast<std::size_t>(k)]);
    z0 += first[0] * of[0] + first[1] * of[1];
    z1 += second[0] * of[0] + second[1] * of[1];
  }
  y[2 * node] = y0 + z0;
  y[2 * node + 1] = y1 + z1;
}

}  // namespace

SparseSymmetric sparse_symmetric(int nodes, const std::vector<std::pair<int, int>>& edges) {
  SparseSymmetric m;
  m.nodes = nodes;
  make_graph(m, edges);
  make_values(m);
  return m;
}

SparseSymmetric sparse_symmetric(std::vector<int> graph_start, std::vector<int> graph) {
  SparseSymmetric m;
  m.nodes = static_cast<int>(graph_start.size()) - 1;
  m.graph_start = std::move(graph_start);
  m.graph = std::move(graph);
  make_values(m);
  return m;
}

// The two columns of a node have the same rows below their diagonal block.
void multiply(const SparseSymmetric& A, const Eigen::VectorXd& x, Eigen::VectorXd& y) {
  if (present_team() && !A.earlier_start.empty()) {
    y.resize(A.size());
    constexpr std::ptrdiff_t kNodesTogether = 1024;
    each_in_ranges(A.nodes, kNodesTogether,
                   [&](std::ptrdiff_t j) { multiply_rows(A, j, x.data(), y.data()); });
    return;
  }
  y.setZero(A.size());
  for (int j = 0; j < A.nodes; ++j) {
    const auto node = static_cast<std::size_t>(j);
    const double* first = &A.value[static_cast<std::size_t>(A.first_column(node))];
    const double* second = &A.value[static_cast<std::size_t>(A.second_column(node))];
    const double x0 = x[2 * j], x1 = x[2 * j + 1];
    double y0 = first[0] * x0 + first[1] * x1, y1 = first[1] * x0 + second[0] * x1;
    first += 2;
    second += 1;
    for (int k = A.graph_start[node]; k < A.graph_start[node + 1]; ++k, first += 2, second += 2) {
      const int i = 2 * A.graph[static_cast<std::size_t>(k)];
      y0 += first[0] * x[i] + first[1] * x[i + 1];
      y1 += second[0] * x[i] + second[1] * x[i + 1];
      y[i] += first[0] * x0 + second[0] * x1;
      y[i + 1] += first[1] * x0 + second[1] * x1;
    }
    y[2 * j] += y0;
    y[2 * j + 1] += y1;
  }
}

void add_block(SparseSymmetric& matrix, int i, int j, const Eigen::Matrix2d& block) {
  const BlockPlace place = find_block(matrix, i, j);
  double* first = &matrix.value[static_cast<std::size_t>(place.first_column)];
  double* second = &matrix.value[static_cast<std::size_t>(place.second_column)];
  first[0] += block(0, 0);
  first[1] += block(1, 0);
  if (i != j) *second++ += block(0, 1);
  *second += block(1, 1);
}

void add_block(SparseSymmetric& matrix, const std::array<int, 3>& nodes,
               const Eigen::Matrix<double, 6, 6>& block) {
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const int i = nodes[static_cast<std::size_t>(a)];
      const int j = nodes[static_cast<std::size_t>(b)];
      if (i >= j && j >= 0) add_block(matrix, i, j, block.block<2, 2>(2 * a, 2 * b));
    }
}

}  // namespace foldless
