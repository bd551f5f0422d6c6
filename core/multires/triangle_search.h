// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Finds triangles of a rest mesh that may lie over itself, each from one near by. The mesh
/// outlives it and does not change.
class TriangleSearch {
 public:
  explicit TriangleSearch(const MeshPair& mesh);

  /// The triangle that holds p at rest, sought from one near by, the nearest first: triangles of
  /// other sheets are far away. The nearest where rounding of the boundary leaves p outside of all.
  int triangle_of(const Vec2& p, int near_by);

 private:
  bool holds(int triangle, const Vec2& p) const;
  double distance(int triangle, const Vec2& p) const;

  const MeshPair& mesh_;
  int searches_ = 0;
  std::vector<int> seen_;  ///< the search in which a triangle was seen last
  std::vector<std::pair<double, int>> heap_;
};

}  // namespace foldless
