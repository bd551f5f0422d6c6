// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "core/energy/element_loops.h"
#include "core/energy/node_blocks.h"

// Sums over triangles, a few at a time, so that what they give stays in the cache until it is added
// up.

namespace foldless {

constexpr std::ptrdiff_t kTrianglesAtATime = 64;

/// What so many triangles give.
struct ElementRoom {
  std::array<ElementEnergy, kTrianglesAtATime> energies;
  std::array<Matrix2<double>, kTrianglesAtATime> gradients;
  std::array<BlocksOf<double>, kTrianglesAtATime> hessians;

  ElementResults results() { return {energies.data(), gradients.data(), hessians.data()}; }
};

/// visit(begin, end) for ranges of a few triangles that make up first … last.
template <class Visit>
void for_few(std::ptrdiff_t first, std::ptrdiff_t last, const Visit& visit) {
  for (std::ptrdiff_t begin = first; begin < last; begin += kTrianglesAtATime)
    visit(begin, std::min(begin + kTrianglesAtATime, last));
}

/// Of a few triangles. Sums over all of them are sums of these, whoever takes them.
inline ElementEnergy sum_of_few(std::span<const ElementEnergy> few) {
  ElementEnergy sum;
  for (const auto& [distortion, barrier] : few) {
    sum.distortion += distortion;
    sum.barrier += barrier;
  }
  return sum;
}

/// Triangles begin ≤ t < end, and what they give. They add it to the vertices, or columns, that
/// owns(v) says.
struct FewElements {
  const ElementRoom& room;
  const Triangles& triangles;
  std::ptrdiff_t begin, end;

  ElementEnergy energy() const {
    return sum_of_few(std::span(room.energies).first(static_cast<std::size_t>(end - begin)));
  }

  template <class Owns>
  void add_gradients(const Owns& owns, Eigen::VectorXd& gradient) const {
    for (std::ptrdiff_t t = begin; t < end; ++t)
      for (int corner = 0; corner < 3; ++corner) {
        const int v = triangles(corner, t);
        if (!owns(v)) continue;
        gradient.segment<2>(2 * static_cast<Eigen::Index>(v)) +=
            gradient_of_corner(room.gradients[static_cast<std::size_t>(t - begin)], corner);
      }
  }

  /// node_of(v) is −1 for a vertex that is no unknown.
  template <class Owns, class NodeOf>
  void add_hessians(const Owns& owns, const NodeOf& node_of, SparseSymmetric& hessian) const {
    for (std::ptrdiff_t t = begin; t < end; ++t) {
      std::array<int, 3> nodes;
      for (int corner = 0; corner < 3; ++corner)
        nodes[static_cast<std::size_t>(corner)] = node_of(triangles(corner, t));
      add_triangle(room.hessians[static_cast<std::size_t>(t - begin)], nodes, owns, hessian);
    }
  }

 private:
  template <class Owns>
  static void add_triangle(const BlocksOf<double>& blocks, const std::array<int, 3>& nodes,
                           const Owns& owns, SparseSymmetric& hessian) {
    for (int column = 0; column < 3; ++column) {
      const int j = nodes[static_cast<std::size_t>(column)];
      if (j < 0) continue;
      if (owns(j)) add_diagonal_block(block_of_corners(blocks, column, column), j, hessian);
      for (int row = 0; row < column; ++row) {
        const int i = nodes[static_cast<std::size_t>(row)];
        if (i < 0 || !owns(std::min(i, j))) continue;
        if (i > j)
          add_later_block(block_of_corners(blocks, row, column), i, j, hessian);
        else
          add_later_block(block_of_corners(blocks, column, row), j, i, hessian);
      }
    }
  }
};

}  // namespace foldless
