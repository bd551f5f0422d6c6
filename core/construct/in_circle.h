// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// Whether d is inside of the circle through a, b, c, counter-clockwise, by more than rounding can
/// claim, so that flips to Delaunay triangles end.
inline bool is_in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  constexpr double kLeastDeterminant = 1e-12;  // of the bound of Hadamard
  const Vec2 p = a - d, q = b - d, r = c - d;
  const double pp = p.squaredNorm(), qq = q.squaredNorm(), rr = r.squaredNorm();
  const double determinant = pp * cross(q, r) + qq * cross(r, p) + rr * cross(p, q);
  return determinant > 0 && determinant * determinant > kLeastDeterminant * kLeastDeterminant *
                                                            (pp + pp * pp) * (qq + qq * qq) *
                                                            (rr + rr * rr);
}

}  // namespace foldless
