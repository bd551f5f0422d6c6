// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string_view>
#include <utility>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/method.h"
#include "core/method/satisfied.h"

namespace foldless::test {

/// The record of the last step.
inline Iteration run_to_its_end(Method& method) {
  Iteration last;
  while (const auto iteration = method.step({})) last = *iteration;
  return last;
}

/// Every handle is at its target.
inline bool is_satisfied(const Method& method, const Iteration& last) {
  const double diagonal = bounding_box_diagonal(method.mesh().rest());
  return last.handle_error_squared <= kSatisfied * diagonal * diagonal;
}

/// A handle that keeps its vertex where it is at rest.
inline Handle held(const Points& rest, int vertex) {
  return {.id = vertex, .vertex = vertex, .target = rest.col(vertex)};
}

/// A grid of diagonal about 1 whose last corner is pulled.
inline Problem pulled_grid(std::string_view energy, const Vec2& pull) {
  const Shape shape = grid({.columns = 6, .rows = 6, .width = 0.7, .height = 0.7});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density(energy), {}, {}};
  problem.handles = {held(shape.rest, 0), held(shape.rest, 6), held(shape.rest, 42),
                     held(shape.rest, 48)};
  problem.handles[3].target += pull;
  return problem;
}

/// The paper's twist on a disk of diameter 0.7: the boundary is held and a ring is turned.
struct Twist {
  DiskOptions disk{.radius = 0.35};
  int ring = 5;
  double degrees = 150;
  std::string_view energy = "lscm";
};

inline Problem turned_disk(const Twist& twist) {
  const Shape shape = disk(twist.disk);
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density(twist.energy), {}, {}};
  for (const int v : disk_ring(twist.disk, twist.disk.rings))
    problem.handles.push_back(held(shape.rest, v));
  const Eigen::Rotation2Dd turn(twist.degrees * std::numbers::pi / 180);
  for (const int v : disk_ring(twist.disk, twist.ring)) {
    problem.handles.push_back(held(shape.rest, v));
    problem.handles.back().target = turn * shape.rest.col(v);
  }
  return problem;
}

}  // namespace foldless::test
