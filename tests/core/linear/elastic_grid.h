// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/linear/interpolation.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless::test {

/// n × n squares of two triangles each that stretch and shear, held at the left side: its rows and
/// columns are those of the identity.
inline SparseSymmetric elastic_grid(int n) {
  const auto node = [n](int i, int j) { return j * (n + 1) + i; };
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      triangles.push_back({node(i, j), node(i + 1, j), node(i, j + 1)});
      triangles.push_back({node(i + 1, j + 1), node(i, j + 1), node(i + 1, j)});
    }
  std::vector<std::pair<int, int>> edges;
  for (const auto& [a, b, c] : triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
  SparseSymmetric m = sparse_symmetric((n + 1) * (n + 1), edges);
  // Of (u₁ − u₀, u₂ − u₀), the derivatives along two sides: their squares and that of their sum.
  Eigen::Matrix<double, 4, 6> sides = Eigen::Matrix<double, 4, 6>::Zero();
  sides.leftCols<2>() << -1, 0, 0, -1, -1, 0, 0, -1;
  sides.rightCols<4>().setIdentity();
  const Eigen::Matrix<double, 1, 6> divergence = sides.row(0) + sides.row(3);
  const Eigen::Matrix<double, 6, 6> block =
      sides.transpose() * sides + 2 * divergence.transpose() * divergence;
  const auto is_held = [n](int i) { return i % (n + 1) == 0; };
  for (std::array<int, 3> corners : triangles) {
    for (int& corner : corners)
      if (is_held(corner)) corner = -1;
    add_block(m, corners, block);
  }
  for (int i = 0; i < m.nodes; ++i)
    if (is_held(i)) add_block(m, i, i, Eigen::Matrix2d::Identity());
  return m;
}

/// From elastic_grid(n) to elastic_grid(2n): nodes in the middle of a coarse edge have the mean of
/// its ends, and nothing moves at the left side.
inline Interpolation to_twice_as_fine(int n) {
  std::vector<Interpolation::Place> places;
  for (int j = 0; j <= 2 * n; ++j)
    for (int i = 0; i <= 2 * n; ++i) {
      // The middle of a square is on the diagonal of its triangles.
      const int right = (i + 1) / 2, below = j / 2, left = i / 2, above = (j + 1) / 2;
      const std::array<std::array<int, 2>, 2> ends{{{left, above}, {right, below}}};
      Interpolation::Place place;
      for (std::size_t k = 0; k < 2; ++k) {
        place.nodes[k] = ends[k][1] * (n + 1) + ends[k][0];
        place.weights[k] = i == 0 || ends[k][0] == 0 ? 0 : 0.5;
      }
      places.push_back(place);
    }
  return {std::move(places), (n + 1) * (n + 1)};
}

}  // namespace foldless::test
