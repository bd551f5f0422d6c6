// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mesh/mesh_pair.h"
#include "core/mesh/shape.h"

namespace foldless::test {

/// The smallest angle of all triangles, in degrees; negative when a triangle is clockwise.
inline double min_angle(const Shape& shape) {
  double smallest = 180;
  for (const auto& t : shape.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = shape.rest.col(t[(k + 1) % 3]) - shape.rest.col(t[k]);
      const Vec2 b = shape.rest.col(t[(k + 2) % 3]) - shape.rest.col(t[k]);
      const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
      smallest = std::min(smallest, angle * 180 / std::numbers::pi);
    }
  return smallest;
}

/// The longest edge of all triangles.
inline double max_edge_length(const Shape& shape) {
  double longest = 0;
  for (const auto& t : shape.triangles.colwise())
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (shape.rest.col(t[k]) - shape.rest.col(t[(k + 1) % 3])).norm());
  return longest;
}

/// The sum of all signed areas.
inline double area_of(const Shape& shape) {
  double sum = 0;
  for (const auto& t : shape.triangles.colwise()) sum += signed_area(shape.rest, t);
  return sum;
}

/// Number of vertices on the boundary.
inline int boundary_vertex_count(const Shape& shape) {
  const MeshPair mesh(shape.triangles, shape.rest);
  int count = 0;
  for (int v = 0; v < mesh.vertex_count(); ++v) count += mesh.is_boundary_vertex(v) ? 1 : 0;
  return count;
}

/// V − E + F: 1 for a disk, 0 for an annulus.
inline int euler_characteristic(const Shape& shape) {
  const MeshPair mesh(shape.triangles, shape.rest);
  return mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
}

}  // namespace foldless::test
