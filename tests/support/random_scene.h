// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/method.h"
#include "tests/support/random_vector.h"

namespace foldless::test {

/// A grid, disk or annulus with its interior vertices shaken, as far as all triangles stay
/// positive.
inline Shape random_shape(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Shape shape;
  switch (random() % 3) {
    case 0: {
      const int n = 4 + static_cast<int>(random() % 6);
      shape = grid({.columns = n, .rows = n, .width = 0.7, .height = 0.7});
      break;
    }
    case 1:
      shape = disk({.rings = 5, .boundary_vertices = 24, .vertices = 76, .radius = 0.35});
      break;
    default:
      shape = annulus({.inner_radius = 0.15, .outer_radius = 0.35, .sectors = 20, .layers = 4});
  }
  const double amount = 0.03 * unit(random);
  for (Eigen::Index v = 0; v < shape.rest.cols(); ++v) {
    Points moved = shape.rest;
    moved.col(v) += amount * (random_vector(unit, random) - Vec2(0.5, 0.5));
    const bool valid = std::ranges::all_of(shape.triangles.colwise(), [&](const auto& t) {
      return (t.array() != v).all() || signed_area(moved, t) > 1e-5;
    });
    if (valid) shape.rest = moved;
  }
  return shape;
}

/// A scene whose targets may be anywhere: many cannot be reached, which a solver must survive.
inline Problem random_problem(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const Shape shape = random_shape(random);
  Problem problem;
  problem.mesh = MeshPair(shape.triangles, shape.rest);
  problem.energy = &densities()[random() % densities().size()];
  const double deltas[] = {1e-5, 1e-3, 1e-1};
  problem.parameters.delta = deltas[random() % 3];
  const int handles = 2 + static_cast<int>(random() % 6);
  const double reach = 0.1 + 0.9 * unit(random);
  std::vector<int> vertices;
  for (int v = 0; v < problem.mesh.vertex_count(); ++v) vertices.push_back(v);
  std::shuffle(vertices.begin(), vertices.end(), random);
  for (int i = 0; i < handles; ++i) {
    Handle handle;
    handle.id = i;
    handle.vertex = vertices[static_cast<std::size_t>(i)];
    handle.target =
        shape.rest.col(handle.vertex) + reach * (random_vector(unit, random) - Vec2(0.5, 0.5));
    problem.handles.push_back(handle);
  }
  return problem;
}

}  // namespace foldless::test
