// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "core/depth/overlaps.h"
#include "core/snapshot.h"
#include "tests/support/meshes.h"

namespace foldless::test {

/// All pairs of overlapping triangles of a mesh.
inline std::vector<Overlap> overlapping_triangles(const Triangles& triangles, const Points& points,
                                                  CommonCorners corners) {
  return OverlapSearch(triangles, static_cast<int>(points.cols())).find(points, corners);
}

/// A straight strip of `cells` × 2 cells, of x in [from, to] and y in ±half_width; the vertices of
/// one x after another, three of each.
inline Fixture ribbon(int cells, double from, double to, double half_width) {
  Fixture f;
  f.rest.resize(2, 3 * (cells + 1));
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j < 3; ++j)
      f.rest.col(3 * i + j) = Vec2(from + (to - from) * i / cells, (j - 1) * half_width);
  f.triangles.resize(3, 4 * cells);
  int t = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < 2; ++j) {
      const int a = 3 * i + j;
      f.triangles.col(t++) << a, a + 3, a + 4;
      f.triangles.col(t++) << a, a + 4, a + 1;
    }
  return f;
}

/// Lays the middle of a ribbon on a curve, its width across.
inline Points along(const Points& ribbon, const std::function<Vec2(double)>& curve) {
  Points points(2, ribbon.cols());
  for (Eigen::Index v = 0; v < ribbon.cols(); ++v) {
    const double x = ribbon(0, v), h = 1e-5;
    const Vec2 tangent = (curve(x + h) - curve(x - h)).normalized();
    points.col(v) = curve(x) + ribbon(1, v) * Vec2(-tangent.y(), tangent.x());
  }
  return points;
}

/// A curve that crosses itself once, at the origin for x = ±1, there at right angles.
inline Vec2 loop(double x) { return {x * x - 1, x * (x * x - 1)}; }

/// Both meshes as one with two components.
inline Fixture both(const Fixture& a, const Fixture& b) {
  Fixture f;
  f.rest.resize(2, a.rest.cols() + b.rest.cols());
  f.rest << a.rest, b.rest;
  f.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  f.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.rest.cols())).matrix();
  return f;
}

/// A snapshot with a revision of its own.
inline Snapshot posed(const Fixture& fixture, Points deformed) {
  static std::uint64_t revision = 1U << 30;
  Snapshot snapshot;
  snapshot.revision = ++revision;
  snapshot.triangles = std::make_shared<const Triangles>(fixture.triangles);
  snapshot.rest = std::make_shared<const Points>(fixture.rest);
  snapshot.deformed = std::move(deformed);
  snapshot.original_vertices = static_cast<int>(fixture.rest.cols());
  return snapshot;
}

/// A ribbon that crosses itself once, with a handle at either end: 0 where x is least and 1.
inline Snapshot crossing_ribbon() {
  const Fixture fixture = ribbon(40, -1.6, 1.6, 0.15);
  Snapshot snapshot = posed(fixture, along(fixture.rest, loop));
  for (const int vertex : {1, 3 * 40 + 1}) {
    Handle handle;
    handle.id = static_cast<int>(snapshot.handles.size());
    handle.vertex = vertex;
    handle.target = snapshot.deformed.col(vertex);
    snapshot.handles.push_back(handle);
  }
  return snapshot;
}

}  // namespace foldless::test
