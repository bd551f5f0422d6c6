// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "core/method/foldless/workspace.h"
#include "tests/support/random_scene.h"
#include "tests/support/valid_pair.h"

namespace foldless::test {

/// Handles on their targets in a random map, `splits` of its edges split.
inline Workspace arrived_workspace(std::uint64_t seed, int splits = 0) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  Problem problem = random_problem(seed);
  MeshPair& mesh = problem.mesh;
  for (int k = 0; k < splits; ++k)
    mesh.split_edge(static_cast<int>(random() % static_cast<unsigned>(mesh.edge_count())), 0.4);
  Constraints constraints = constraints_of(problem.handles);
  EnergySettings energy{.density = problem.energy, .beta = 2, .delta = 1e-5};
  energy.barrier_area_weighted = true;
  NewtonSystem system(energy, mesh, constraints);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    Points step = Points::Zero(2, mesh.vertex_count());
    step.col(v) = 0.3 * Vec2(unit(random) - 0.5, unit(random) - 0.5);
    const double largest = system.objective().largest_step(mesh.deformed(), step);
    mesh.set_deformed(mesh.deformed() + std::min(1.0, 0.7 * largest) * step);
  }
  constraints = held_where_they_are(constraints, mesh.deformed());
  return {mesh, std::move(constraints), std::move(system), problem.parameters.eta, true};
}

}  // namespace foldless::test
