// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "core/mesh/generate.h"

namespace foldless::test {

/// A strip wound `turns` times round an annulus: it lies over itself, one sheet a turn. Vertex
/// (i, j), i along the strip and j across it, has index j (columns + 1) + i.
inline Shape wound_strip(int columns, int rows, double turns) {
  Shape shape = grid({.columns = columns, .rows = rows, .diagonal = Diagonal::alternating});
  for (Eigen::Index v = 0; v < shape.rest.cols(); ++v) {
    const double angle = -2 * std::numbers::pi * turns * shape.rest(0, v);
    shape.rest.col(v) = (1 + shape.rest(1, v)) * Vec2(std::cos(angle), std::sin(angle));
  }
  return shape;
}

}  // namespace foldless::test
