// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <numbers>

#include "core/method/foldless/coarse_problem.h"
#include "tests/core/method/method_fixture.h"

namespace foldless::test {

/// Small enough for tests; a coarse mesh is not coarsened again.
inline constexpr CoarseSettings kSmall{.dense_from = 600, .least_vertices = 200, .ratio = 4};
inline constexpr CoarseSettings kNever{.dense_from = std::numeric_limits<int>::max()};

inline MeshPair grid_mesh(int columns, int rows) {
  const Shape shape = grid({.columns = columns,
                            .rows = rows,
                            .width = 0.9,
                            .height = 0.9 * rows / columns,
                            .diagonal = Diagonal::alternating});
  return {shape.triangles, shape.rest};
}

/// A grid held at its left side, the right side turned by a quarter and lifted.
inline Problem bent_grid(int columns, int rows) {
  Problem problem{grid_mesh(columns, rows), find_density("arap"), {}, {}};
  const Points& rest = problem.mesh.rest();
  const Eigen::Rotation2Dd turn(std::numbers::pi / 2);
  for (int j = 0; j <= rows; ++j) {
    const int left = j * (columns + 1), right = left + columns;
    problem.handles.push_back(held(rest, left));
    problem.handles.push_back(held(rest, right));
    problem.handles.back().target = turn * (rest.col(right) - rest.col(columns)) + Vec2(0.75, 0.3);
  }
  return problem;
}

/// 915 vertices; its coarse mesh has about 228.
inline Problem bent_bar() { return bent_grid(60, 14); }

/// A soft handle somewhere in the middle of the bar, off where it is.
inline Handle soft_handle_of(const Problem& bar) {
  Handle handle = held(bar.mesh.rest(), 7 * 61 + 30);
  handle.kind = HandleKind::soft;
  handle.target += Vec2(0.05, 0.1);
  return handle;
}

}  // namespace foldless::test
