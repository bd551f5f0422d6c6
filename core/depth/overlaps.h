// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Two triangles that cover a common area, the smaller index first, or that only touch.
struct Overlap {
  int a = 0, b = 0;
  bool is_contact = false;  ///< they touch within rounding, and have no common corner

  bool operator==(const Overlap&) const = default;
};

/// Whether triangles with a common corner are looked at too: they lie over each other only where
/// the angles at a boundary vertex add up to more than 2π.
enum class CommonCorners { apart, may_overlap };

/// Looks for the triangles that cover a common area in one map of a mesh after another. Where a
/// piece of the overlap ends one of its sheets has its boundary: from the triangles that boundary
/// edges lie on, the pieces are walked through over edges. So a search costs little beside what it
/// finds.
class OverlapSearch {
 public:
  /// Keeps a reference. Precondition: oriented manifold triangles.
  OverlapSearch(const Triangles& triangles, int vertex_count);

  /// All pairs that cover a common area, and some that touch, sorted. Precondition: the triangles
  /// are counter-clockwise in `points` and cover each interior vertex once.
  std::vector<Overlap> find(const Points& points, CommonCorners corners) const;

 private:
  struct Side {
    int to, triangle;
  };
  struct BoundaryEdge {
    int from, to, triangle;
  };

  int triangle_of_side(int from, int to) const;
  std::vector<Overlap> at_boundary(const Points& points) const;
  std::array<int, 3> neighbours(int triangle) const;

  const Triangles& triangles_;
  std::vector<int> first_;   ///< of the sides that leave a vertex, one past the last at the end
  std::vector<Side> sides_;  ///< of all triangles
  std::vector<BoundaryEdge> boundary_;
};

}  // namespace foldless
