// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// Of a triangle, one a column.
using Corners = Eigen::Matrix<double, 2, 3>;

/// True when two counter-clockwise triangles share area; exact.
bool share_area(const Corners& a, const Corners& b);

/// The corners of a triangle.
inline Corners corners_of(const Points& points, const Eigen::Vector3i& t) {
  Corners corners;
  corners << points.col(t[0]), points.col(t[1]), points.col(t[2]);
  return corners;
}

/// Barycentric coordinates of a point in a triangle that has area; they add up to 1.
Eigen::Vector3d barycentric(const Corners& corners, const Vec2& point);

}  // namespace foldless
