// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/mesh/triangle.h"

namespace foldless {

/// As orientation(), always in exact arithmetic.
int exact_orientation(const Vec2& a, const Vec2& b, const Vec2& c);

/// Sign of the area of the triangle a, b, c, exact: +1 counter-clockwise, −1 clockwise,
/// 0 collinear. Also 0 when a coordinate is not finite. Nearly every call ends in the float
/// filter of [She97]; only near zero is exact arithmetic asked.
inline int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double determinant = left - right;
  // 4 ε covers Shewchuk's (3 + 16 ε) ε with ε = 2⁻⁵³; the addend covers underflow. Overflow
  // makes the comparison false.
  const double bound = 0x1p-51 * (std::abs(left) + std::abs(right)) + 1e-300;
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_orientation(a, b, c);
}

/// Orientation of one triangle of a mesh, as orientation(a, b, c).
inline int orientation(const Points& points, const Eigen::Vector3i& t) {
  return orientation(points.col(t[0]), points.col(t[1]), points.col(t[2]));
}

}  // namespace foldless
