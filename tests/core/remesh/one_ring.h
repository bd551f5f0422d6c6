// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "core/mesh/injective.h"
#include "core/mesh/mesh_pair.h"

namespace foldless::test {

inline const Vec2 kEast(1, 0);

/// Vertex 0 at the origin with a closed link, vertices 1, 2, … counter-clockwise.
inline MeshPair one_ring(const std::vector<Vec2>& link) {
  const int n = static_cast<int>(link.size());
  Points points(2, n + 1);
  points.col(0).setZero();
  Triangles triangles(3, n);
  for (int k = 0; k < n; ++k) {
    points.col(k + 1) = link[static_cast<std::size_t>(k)];
    triangles.col(k) << 0, k + 1, (k + 1) % n + 1;
  }
  EXPECT_TRUE(is_injective(triangles, points));
  return {triangles, points};
}

/// Figure 4 (a): the way leads through the inside of one link edge.
inline MeshPair figure_4a() { return one_ring({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}); }

/// Figure 4 (b): the line through 3–4 crosses the way first, outside of the edge, nearer to 3.
inline MeshPair figure_4b() {
  return one_ring({{3, -1}, {3, 1}, {0.6, 1.2}, {0, 3}, {-3, 0}, {0, -3}});
}

/// Figure 16: the line x = 1 carries 2–3 above the way and 6–7–1 below; v_α = (1, 0) is on none.
inline MeshPair figure_16() {
  return one_ring({{1, -1}, {4, 0}, {1, 2}, {1, 4}, {-2, 0}, {1, -6}, {1, -3}});
}

}  // namespace foldless::test
