// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "core/mesh/injective.h"
#include "tests/support/random_vector.h"

namespace foldless::test {

/// A random polygon that bounds an immersed disk, which often lies over itself: triangles that are
/// glued side to side as long as no angle reaches 2π.
inline Points glued_polygon(std::mt19937_64& random, int corners) {
  std::uniform_real_distribution<double> unit(0, 1);
  Points points(2, 3);
  points << 0, 1, 0.5,  //
      0, 0, 0.8;
  Triangles triangles(3, 1);
  triangles.col(0) << 0, 1, 2;
  std::vector<int> loop{0, 1, 2};
  while (static_cast<int>(loop.size()) < corners) {
    const std::size_t side = random() % loop.size();
    const int i = loop[side], j = loop[(side + 1) % loop.size()];
    const Vec2 way = points.col(j) - points.col(i), right(way.y(), -way.x());
    const double along = -0.3 + 1.6 * unit(random);
    const double away = (0.2 + unit(random)) / std::max(1.0, way.norm());
    Points more(2, points.cols() + 1);
    more << points, points.col(i) + along * way + away * right;
    Triangles glued(3, triangles.cols() + 1);
    glued << triangles, Eigen::Vector3i(i, static_cast<int>(points.cols()), j);
    if (!is_injective(glued, more)) continue;
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(side) + 1,
                static_cast<int>(points.cols()));
    points = more;
    triangles = glued;
  }
  return points(Eigen::all, loop);
}

/// A regular polygon with its corners on the unit circle.
inline Points regular_polygon(int corners) {
  Points points(2, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / corners;
    points.col(i) = Vec2(std::cos(angle), std::sin(angle));
  }
  return points;
}

}  // namespace foldless::test
