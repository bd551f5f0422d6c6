// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/mesh/triangle.h"

namespace foldless {

/// Whether d is inside of the circle through a, b, c, counter-clockwise, by more than rounding can
/// claim, so that flips to Delaunay triangles end.
inline bool is_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  constexpr double kLeastDeterminant = 1e-12;  // of its bound, whatever the unit of length
  const Vec2 p = a - d, q = b - d, r = c - d;
  const double pp = p.squaredNorm(), qq = q.squaredNorm(), rr = r.squaredNorm();
  const double bound = pp * std::sqrt(qq * rr) + qq * std::sqrt(rr * pp) + rr * std::sqrt(pp * qq);
  return pp * cross(q, r) + qq * cross(r, p) + rr * cross(p, q) > kLeastDeterminant * bound;
}

}  // namespace foldless
