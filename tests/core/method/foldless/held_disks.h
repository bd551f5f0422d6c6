// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/method.h"
#include "tests/support/glued_polygon.h"

namespace foldless::test {

/// A disk whose boundary is to go to a random polygon that bounds one and often overlaps itself.
inline Problem disk_to_glued_polygon(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const DiskOptions options{.rings = 4, .boundary_vertices = 24, .vertices = 61, .radius = 0.35};
  const Shape shape = disk(options);
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  const Points polygon = glued_polygon(random, options.boundary_vertices);
  Eigen::Index corner = 0;
  for (const int v : disk_ring(options, options.rings))
    problem.handles.push_back({.id = v, .vertex = v, .target = 0.3 * polygon.col(corner++)});
  return problem;
}

}  // namespace foldless::test
