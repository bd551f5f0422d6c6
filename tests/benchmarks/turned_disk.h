// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/method.h"

namespace foldless::benchmarks {

/// A disk of diameter 1 and about `faces` triangles that are nearly equilateral.
inline DiskOptions disk_of(int faces) {
  const int rings = static_cast<int>(std::lround(std::sqrt(faces / 6.0)));
  return {rings, 6 * rings, 1 + 3 * rings * (rings + 1), 0.5};
}

/// The paper's twist: the boundary of a disk is held, and the ring half way to it is turned by
/// `degrees`.
inline Problem turned_disk(int faces, double degrees) {
  const DiskOptions options = disk_of(faces);
  const Shape shape = disk(options);
  Problem problem{
      MeshPair(shape.triangles, shape.rest), find_density("symmetric-dirichlet"), {}, {}};
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
  const auto add_ring = [&](int ring, bool turned) {
    for (const int v : disk_ring(options, ring)) {
      const Vec2 rest = shape.rest.col(v);
      const int id = static_cast<int>(problem.handles.size());
      problem.handles.push_back({id, v, turned ? Vec2(turn * rest) : rest});
    }
  };
  add_ring(options.rings / 2, true);
  add_ring(options.rings, false);
  return problem;
}

}  // namespace foldless::benchmarks
