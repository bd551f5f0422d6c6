// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <utility>
#include <vector>

#include "core/energy/densities.h"
#include "core/mesh/generate.h"
#include "core/method/foldless/foldless.h"
#include "core/method/foldless/workspace.h"
#include "tests/support/random_scene.h"
#include "tests/support/random_vector.h"

namespace foldless::test {

/// A workspace with the settings and the effort that it refers to.
struct OwnWorkspace {
  OwnWorkspace(MeshPair mesh, Constraints constraints, RunSettings run_settings)
      : settings(std::move(run_settings)),
        work(std::move(mesh), std::move(constraints), settings, effort) {}
  OwnWorkspace(const OwnWorkspace&) = delete;
  OwnWorkspace& operator=(const OwnWorkspace&) = delete;

  RunSettings settings;
  Effort effort;
  Workspace work;
};

/// Those of `foldless` for an energy.
inline RunSettings run_settings(const Density* density, const MeshPair& mesh) {
  RunSettings settings;
  settings.energy = {.density = density, .beta = 2, .delta = 1e-5};
  settings.energy.barrier_area_weighted = true;
  settings.energy.gap_weight = Foldless::kGapWeight;
  settings.first_removable = mesh.vertex_count();
  return settings;
}

/// A mesh at rest with handles, under ARAP.
inline OwnWorkspace workspace_of(const MeshPair& mesh, const std::vector<Handle>& handles) {
  return {mesh, constraints_of(handles), run_settings(find_density("arap"), mesh)};
}
inline OwnWorkspace workspace_of(const Problem& problem) {
  return workspace_of(problem.mesh, problem.handles);
}

/// Handles on their targets in a random map, `splits` of its edges split.
inline OwnWorkspace arrived_workspace(std::uint64_t seed, int splits = 0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Problem problem = random_problem(seed);
  MeshPair& mesh = problem.mesh;
  RunSettings settings = run_settings(problem.energy, mesh);
  for (int k = 0; k < splits; ++k)
    mesh.split_edge(static_cast<int>(random() % static_cast<unsigned>(mesh.edge_count())), 0.4);
  const Constraints constraints = constraints_of(problem.handles);
  const Objective objective(mesh, constraints);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Points step = Points::Zero(2, mesh.vertex_count());
    step.col(v) = 0.3 * (random_vector(unit, random) - Vec2(0.5, 0.5));
    const double largest = objective.largest_step(settings.energy, mesh.deformed(), step);
    mesh.set_deformed(mesh.deformed() + std::min(1.0, 0.7 * largest) * step);
  }
  return {mesh, with_targets(constraints, handle_positions(constraints, mesh.deformed())),
          std::move(settings)};
}

/// A square grid at rest whose boundary is held, with handles inside that change places.
inline OwnWorkspace held_frame(std::uint64_t seed, std::size_t inner_handles = 4) {
  constexpr int kSide = 7;
  std::mt19937_64 random(seed);
  const Shape shape = grid({.columns = kSide - 1, .rows = kSide - 1, .width = 0.7, .height = 0.7});
  std::vector<int> inside, boundary;
  std::vector<Handle> handles;
  for (int v = 0; v < kSide * kSide; ++v) {
    const int column = v % kSide, row = v / kSide;
    const bool is_boundary = column % (kSide - 1) == 0 || row % (kSide - 1) == 0;
    (is_boundary ? boundary : inside).push_back(v);
    if (is_boundary) handles.push_back({.id = v, .vertex = v, .target = shape.rest.col(v)});
  }
  for (std::size_t left = inside.size(); left > 1; --left)
    std::swap(inside[left - 1], inside[random() % left]);
  for (std::size_t i = 0; i < inner_handles; ++i)
    handles.push_back({.id = inside[i],
                       .vertex = inside[i],
                       .target = shape.rest.col(inside[(i + 1) % inner_handles])});
  const MeshPair mesh(shape.triangles, shape.rest);
  RunSettings settings = run_settings(find_density("arap"), mesh);
  settings.fixed_boundary = boundary;
  return {mesh, constraints_of(handles), std::move(settings)};
}

}  // namespace foldless::test
