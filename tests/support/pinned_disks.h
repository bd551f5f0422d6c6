// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>

#include "core/construct/pinned_disk.h"
#include "core/mesh/generate.h"

namespace foldless::test {

/// A disk of radius 1 with its boundary and vertices inside that are to go somewhere.
struct PinnedDisk {
  MeshPair mesh;
  PinnedVertices pinned;
  Points targets;  ///< those of the boundary first
};

/// The boundary stays; so many random vertices inside change places in a random cycle.
inline PinnedDisk permuted_disk(std::uint64_t seed, int inside) {
  const DiskOptions options{.rings = 5, .boundary_vertices = 30, .vertices = 91, .radius = 1};
  const Shape shape = disk(options);
  PinnedDisk result{{shape.triangles, shape.rest}, {disk_ring(options, options.rings), {}}, {}};
  std::vector<int>& vertices = result.pinned.inside;
  for (int v = 0; v < options.vertices - options.boundary_vertices; ++v) vertices.push_back(v);
  std::mt19937_64 random(seed);
  for (std::size_t left = vertices.size(); left > 1; --left)
    std::swap(vertices[left - 1], vertices[random() % left]);
  vertices.resize(static_cast<std::size_t>(inside));
  std::vector<int> goals = result.pinned.loop;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    goals.push_back(vertices[(i + 1) % vertices.size()]);
  result.targets = shape.rest(Eigen::all, goals);
  return result;
}

}  // namespace foldless::test
