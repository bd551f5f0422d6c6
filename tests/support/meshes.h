// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "core/mesh/triangle.h"

namespace foldless::test {

/// Triangles and rest positions of a named fixture.
struct Fixture {
  Triangles triangles;
  Points rest;
};

/// Two triangles over the unit square, the diagonal from (0,0) to (1,1).
inline Fixture unit_square() {
  Fixture f;
  f.rest.resize(2, 4);
  f.rest << 0, 1, 1, 0,  //
      0, 0, 1, 1;
  f.triangles.resize(3, 2);
  f.triangles << 0, 0,  //
      1, 2,             //
      2, 3;
  return f;
}

/// An n × n square grid of vertices on [0, n−1]², each cell cut from lower left to upper right.
inline Fixture square_grid(int n) {
  Fixture f;
  f.rest.resize(2, n * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) f.rest.col(j * n + i) = Vec2(i, j);
  f.triangles.resize(3, 2 * (n - 1) * (n - 1));
  int t = 0;
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const int a = j * n + i;
      f.triangles.col(t++) << a, a + 1, a + n + 1;
      f.triangles.col(t++) << a, a + n + 1, a + n;
    }
  return f;
}

/// Triangles round the boundary vertex 0 at the origin, rim vertices 1, 2, … on the unit circle,
/// whose angles add up to so much; from a full turn on the mesh overlaps itself at vertex 0.
inline Fixture open_fan(double degrees, int triangles = 6) {
  Fixture f;
  f.rest.setZero(2, triangles + 2);
  f.triangles.resize(3, triangles);
  for (int k = 0; k <= triangles; ++k) {
    const double angle = degrees / 180 * std::numbers::pi * k / triangles;
    f.rest.col(k + 1) = Vec2(std::cos(angle), std::sin(angle));
  }
  for (int k = 0; k < triangles; ++k) f.triangles.col(k) << 0, k + 1, k + 2;
  return f;
}

/// Six triangles round vertex 0 at the origin, rim vertices 1 … 6 on the unit circle.
inline Fixture hexagon() {
  Fixture f;
  f.rest.resize(2, 7);
  f.rest.col(0).setZero();
  f.triangles.resize(3, 6);
  for (int k = 0; k < 6; ++k) {
    const double angle = k * 3.14159265358979323846 / 3;
    f.rest.col(k + 1) = Vec2(std::cos(angle), std::sin(angle));
    f.triangles.col(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  return f;
}

}  // namespace foldless::test
