// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "tests/support/meshes.h"

namespace foldless::test {

/// A disk round vertex 0 without a sector, the notch, of angle `gap` about the positive x-axis: two
/// rings of `triangles` + 1 vertices, 1 … inside at half the radius. Vertex 0 is at the boundary,
/// at the tip of the notch; its neighbours there are the first and the last of the inner ring.
inline Fixture notched_disk(double gap, int triangles = 8) {
  const int ring = triangles + 1;
  Fixture f;
  f.rest.resize(2, 2 * ring + 1);
  f.rest.col(0).setZero();
  f.triangles.resize(3, 3 * triangles);
  for (int k = 0; k < ring; ++k) {
    const double angle = gap / 2 + k * (2 * std::numbers::pi - gap) / triangles;
    f.rest.col(1 + k) = 0.5 * Vec2(std::cos(angle), std::sin(angle));
    f.rest.col(1 + ring + k) = Vec2(std::cos(angle), std::sin(angle));
  }
  for (int k = 0; k < triangles; ++k) {
    const int a = 1 + k, b = 2 + k;
    f.triangles.col(3 * k) << 0, a, b;
    f.triangles.col(3 * k + 1) << a, a + ring, b + ring;
    f.triangles.col(3 * k + 2) << a, b + ring, b;
  }
  return f;
}

/// The map that takes the notch of such a disk from one angle to another, about vertex 0.
inline Points with_notch(const Points& rest, double gap, double other) {
  const double pi = std::numbers::pi;
  Points u = rest;
  for (auto p : u.colwise()) {
    if (p.isZero()) continue;
    const double from_back = std::atan2(-p.y(), -p.x());
    const double angle = pi + from_back * (2 * pi - other) / (2 * pi - gap);
    p = p.norm() * Vec2(std::cos(angle), std::sin(angle));
  }
  return u;
}

}  // namespace foldless::test
