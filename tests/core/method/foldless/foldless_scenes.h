// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/foldless/foldless.h"
#include "tests/support/valid_pair.h"

namespace foldless::test {

/// A grid of 9 × 9 vertices, vertex (i, j) of index 9 j + i, under ARAP; handles are vertices with
/// how far they are to go.
inline Problem grid_problem(const std::vector<std::pair<int, Vec2>>& handles) {
  const Shape shape = grid({.columns = 8, .rows = 8, .width = 0.7, .height = 0.7});
  Problem problem{MeshPair(shape.triangles, shape.rest), find_density("arap"), {}, {}};
  for (const auto& [vertex, move] : handles) {
    Handle handle;
    handle.id = static_cast<int>(problem.handles.size());
    handle.vertex = vertex;
    handle.target = shape.rest.col(vertex) + move;
    problem.handles.push_back(handle);
  }
  return problem;
}

inline bool is_on_boundary_of_grid(int v) { return v % 9 == 0 || v % 9 == 8 || v < 9 || v >= 72; }

/// The boundary of the grid held, but for `but`, and other vertices moved.
inline Problem held_grid(const std::vector<std::pair<int, Vec2>>& moved, int but = -1) {
  std::vector<std::pair<int, Vec2>> handles = moved;
  for (int v = 0; v < 81; ++v)
    if (is_on_boundary_of_grid(v) && v != but) handles.emplace_back(v, Vec2(0, 0));
  return grid_problem(handles);
}

/// The vertices turned by so many degrees about the middle of the grid.
inline std::vector<std::pair<int, Vec2>> turned(const std::vector<int>& vertices, double degrees) {
  const Points rest = grid_problem({}).mesh.rest();
  const Vec2 middle(0.35, 0.35);
  const Eigen::Rotation2Dd turn(degrees * std::numbers::pi / 180);
  std::vector<std::pair<int, Vec2>> moved;
  for (const int v : vertices)
    moved.emplace_back(v, middle + turn * (rest.col(v) - middle) - rest.col(v));
  return moved;
}

/// The boundary of the grid held, a core of four vertices turned by 180° about the middle.
inline Problem swirl() { return held_grid(turned({30, 32, 48, 50}, 180)); }

/// Handles that trade places, two scenes in three with the boundary held: few come home by
/// approaching alone.
inline Problem trading_places(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Points rest = grid_problem({}).mesh.rest();
  std::vector<int> vertices;
  std::vector<std::pair<int, Vec2>> handles;
  for (int v = 0; v < 81; ++v) {
    if (!is_on_boundary_of_grid(v))
      vertices.push_back(v);
    else if (seed % 3 != 0)
      handles.emplace_back(v, Vec2(0, 0));
  }
  std::shuffle(vertices.begin(), vertices.end(), random);
  vertices.resize(6);
  for (std::size_t k = 0; k < vertices.size(); ++k)
    handles.emplace_back(vertices[k],
                         rest.col(vertices[(k + 1) % vertices.size()]) - rest.col(vertices[k]));
  return grid_problem(handles);
}

/// Runs to the end; every mesh on the way is proved.
inline std::vector<Iteration> run_validly(Method& method, int most_steps = 3000) {
  std::vector<Iteration> records;
  for (int step = 0; step < most_steps; ++step) {
    const auto iteration = method.step({});
    if (!iteration) break;
    records.push_back(*iteration);
    EXPECT_TRUE(is_valid(method.mesh())) << "step " << step;
  }
  return records;
}

inline std::set<Phase> phases_of(const std::vector<Iteration>& records) {
  std::set<Phase> phases;
  for (const Iteration& record : records) phases.insert(record.phase);
  return phases;
}

/// The run arrived, and the handles that are not soft are where they should be to the last bit.
inline void expect_on_target(const Method& method, const Problem& problem) {
  EXPECT_EQ(method.outcome(), Outcome::gradient);
  for (const Handle& handle : problem.handles)
    if (handle.kind != HandleKind::soft) {
      EXPECT_EQ(Vec2(method.mesh().deformed().col(handle.vertex)), handle.target) << handle.vertex;
    }
}

}  // namespace foldless::test
