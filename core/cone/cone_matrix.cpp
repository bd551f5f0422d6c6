// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cone/cone_matrix.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

constexpr int kRefinements = 2;
constexpr std::size_t kElementsBetweenLooks = 16384;  ///< at the token

SparseSymmetric pattern_of(int nodes, const std::vector<std::array<int, 3>>& elements) {
  std::vector<std::pair<int, int>> edges;
  edges.reserve(3 * elements.size());
  for (const std::array<int, 3>& corners : elements)
    for (std::size_t a = 0; a < 3; ++a) {
      const std::pair<int, int> edge{corners[a], corners[(a + 1) % 3]};
      if (edge.first >= 0 && edge.second >= 0) edges.push_back(edge);
    }
  return sparse_symmetric(nodes, edges);
}

}  // namespace

CornerVector corners_of(const Eigen::VectorXd& x, const ConeElement& element) {
  CornerVector corners = CornerVector::Zero();
  for (int a = 0; a < 3; ++a) {
    const int node = element.nodes[static_cast<std::size_t>(a)];
    if (node >= 0) corners.segment<2>(2 * a) = x.segment<2>(2 * node);
  }
  return corners;
}

void add_corners(const CornerVector& values, const ConeElement& element, Eigen::VectorXd& x) {
  for (int a = 0; a < 3; ++a) {
    const int node = element.nodes[static_cast<std::size_t>(a)];
    if (node >= 0) x.segment<2>(2 * node) += values.segment<2>(2 * a);
  }
}

ConeMatrix::ConeMatrix(int nodes, const std::vector<std::array<int, 3>>& elements)
    : matrix_(pattern_of(nodes, elements)) {}

bool ConeMatrix::factorize(const ConeProgram& program, const MiddleMatrices& middle) {
  if (is_stopped()) return false;
  {
    StageTimer timer(times_.assemble);
    std::ranges::fill(matrix_.value, 0.0);
    for (std::size_t t = 0; t < program.size(); ++t) {
      if (t % kElementsBetweenLooks == 0 && is_stopped()) return false;
      const ConeElement& e = program[t];
      add_block(matrix_, e.nodes, e.P + e.G.transpose() * middle[t] * e.G);
    }
  }
  if (!cholesky_.is_analyzed()) {
    StageTimer timer(times_.analyze);
    cholesky_.analyze(matrix_);
  }
  StageTimer timer(times_.factorize);
  ++factorizations_;
  return cholesky_.factorize(matrix_);
}

Eigen::VectorXd ConeMatrix::solve(const ConeProgram& program, const MiddleMatrices& middle,
                                  const Eigen::VectorXd& right) {
  StageTimer timer(times_.solve);
  Eigen::VectorXd x = cholesky_.solve(right);
  for (int round = 0; round < kRefinements && !is_stopped(); ++round) {
    Eigen::VectorXd residual = right;
    for (std::size_t t = 0; t < program.size(); ++t) {
      if (t % kElementsBetweenLooks == 0 && is_stopped()) return x;
      const ConeElement& e = program[t];
      const CornerVector corners = corners_of(x, e);
      const CornerVector product = e.P * corners + e.G.transpose() * (middle[t] * (e.G * corners));
      add_corners(-product, e, residual);
    }
    x += cholesky_.solve(residual);
  }
  return x;
}

}  // namespace foldless
