// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/mesh_pair.h"

namespace foldless::test {

/// Where a map takes a point of its rest mesh, by the first triangle that has it.
inline Vec2 image(const MeshPair& map, const Vec2& p) {
  for (const auto& t : map.triangles().colwise()) {
    const Vec2 a = map.rest().col(t[0]);
    Mat2 sides;
    sides << map.rest().col(t[1]) - a, map.rest().col(t[2]) - a;
    const Vec2 part = sides.inverse() * (p - a);
    if (part.minCoeff() < -1e-9 || part.sum() > 1 + 1e-9) continue;
    const Points& u = map.deformed();
    const Vec2 b = u.col(t[0]);
    return b + part[0] * (u.col(t[1]) - b) + part[1] * (u.col(t[2]) - b);
  }
  ADD_FAILURE() << p.transpose() << " is in no triangle";
  return p;
}

/// By how much a map turns about the origin from one end of a straight line at rest to the other,
/// added up along it [rad].
inline double turn_along(const MeshPair& map, const Vec2& from, const Vec2& to) {
  constexpr int kPieces = 2000;
  const auto turned = [&](int k) {
    const Vec2 p = from + (k / static_cast<double>(kPieces)) * (to - from), q = image(map, p);
    return Vec2(q.dot(p), p.x() * q.y() - p.y() * q.x());
  };
  double turn = 0;
  Vec2 before = turned(0);
  for (int k = 1; k <= kPieces; ++k) {
    const Vec2 now = turned(k);
    turn += std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
    before = now;
  }
  return turn;
}

}  // namespace foldless::test
