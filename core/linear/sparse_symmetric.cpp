// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/sparse_symmetric.h"

#include <algorithm>
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

/// The ranges of a product, all in one where one thread will do.
void make_ranges(SparseSymmetric& m) {
  constexpr int kSharedFrom = 1024, kRanges = 8, kFewest = 256, kMost = 4096;
  m.range = m.nodes;
  if (present_team() && m.nodes >= kSharedFrom)
    m.range = std::clamp(m.nodes / kRanges, kFewest, kMost);
  m.crossings.assign(static_cast<std::size_t>(m.nodes > 0 ? (m.nodes - 1) / m.range + 1 : 0), {});
  if (m.range == m.nodes) return;
  for (int j = 0, end = m.range; j < m.nodes; ++j) {
    if (j == end) end += m.range;
    const auto node = static_cast<std::size_t>(j);
    const int first = m.first_column(node) + 2, second = m.second_column(node) + 1;
    for (int k = m.graph_start[node + 1]; k-- > m.graph_start[node];) {
      const int i = m.graph[static_cast<std::size_t>(k)];
      if (i < end) break;
      const int rank = k - m.graph_start[node];
      m.crossings[static_cast<std::size_t>(i / m.range)].push_back(
          {i, j, {first + 2 * rank, second + 2 * rank}});
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
  make_ranges(m);
}

/// The rows of a range of nodes, which may be `All`: what columns before it add, then its own.
template <bool All>
// NOLINTNEXTLINE(readability-function-size): y = A x
void multiply_range(const SparseSymmetric& A, std::size_t range, const double* x, double* y) {
  const int begin = static_cast<int>(range) * A.range, end = std::min(begin + A.range, A.nodes);
  std::fill(y + 2 * static_cast<std::ptrdiff_t>(begin), y + 2 * static_cast<std::ptrdiff_t>(end),
            0.0);
  for (const auto& [row, column, place] : A.crossings[range]) {
    const double* first = &A.value[static_cast<std::size_t>(place.first_column)];
    const double* second = &A.value[static_cast<std::size_t>(place.second_column)];
    const double* of = x + 2 * static_cast<std::ptrdiff_t>(column);
    double* to = y + 2 * static_cast<std::ptrdiff_t>(row);
    to[0] += first[0] * of[0] + second[0] * of[1];
    to[1] += first[1] * of[0] + second[1] * of[1];
  }
  for (int j = begin; j < end; ++j) {
    const auto node = static_cast<std::size_t>(j);
    const double* first = &A.value[static_cast<std::size_t>(A.first_column(node))];
    const double* second = &A.value[static_cast<std::size_t>(A.second_column(node))];
    const double x0 = x[2 * node], x1 = x[2 * node + 1];
    double y0 = first[0] * x0 + first[1] * x1, y1 = first[1] * x0 + second[0] * x1;
    first += 2;
    second += 1;
    for (int k = A.graph_start[node]; k < A.graph_start[node + 1]; ++k, first += 2, second += 2) {
      const int i = A.graph[static_cast<std::size_t>(k)];
      const double* of = x + 2 * static_cast<std::ptrdiff_t>(i);
      y0 += first[0] * of[0] + first[1] * of[1];
      y1 += second[0] * of[0] + second[1] * of[1];
      if (!All && i >= end) continue;
      double* to = y + 2 * static_cast<std::ptrdiff_t>(i);
      to[0] += first[0] * x0 + second[0] * x1;
      to[1] += first[1] * x0 + second[1] * x1;
    }
    y[2 * node] += y0;
    y[2 * node + 1] += y1;
  }
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
  y.resize(A.size());
  in_parallel(static_cast<int>(A.crossings.size()), [&](int range) {
    const auto place = static_cast<std::size_t>(range);
    if (A.crossings.size() == 1)
      multiply_range<true>(A, place, x.data(), y.data());
    else
      multiply_range<false>(A, place, x.data(), y.data());
  });
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
