// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/workspace.h"

#include <utility>

namespace foldless {
namespace {

/// Flipping on every step is slower, never on full steps locks.
constexpr double kShortStep = 0.5;
constexpr int kStepsBetweenFlips = 3;
/// Flips of little gain wait for the end of the descent: each call that flips costs an analysis.
constexpr double kLeastGainWhileHeld = 2e-3;

/// Of an edge that is split. [D]
constexpr double kShortestHalf = 1e-5;

/// E_d + E_b may grow by this factor when handles are put on their targets.
constexpr double kGrowthOfASnap = 1.5;

SplitSettings split_settings(const Workspace& workspace) {
  return {.shortest_edge = kShortestHalf,
          .delta = workspace.system.objective().settings().delta,
          .fixed_boundary = workspace.fixed_boundary};
}

}  // namespace

VertexUpdate Workspace::descend(const Positions& aimed, std::stop_token token) {
  const VertexUpdate update = foldless::descend(system, mesh, aimed, curvature, token);
  if (update.cancelled) return update;
  ++steps_since_flips;
  if (update.step_length < kShortStep || steps_since_flips >= kStepsBetweenFlips)
    flip_edges(aimed.held ? kLeastGainWhileHeld : 0);
  return update;
}

int Workspace::flip_edges(double least_gain) {
  steps_since_flips = 0;
  int flipped = 0;
  {
    StageTimer timer(system.times.flip);
    const Objective& objective = system.objective();
    flipped = foldless::flip_edges(mesh, objective.unknowns(),
                                   {objective.settings(), eta, condition_test, least_gain});
  }
  if (flipped > 0) system.take_flips(mesh, flipped);
  flips += flipped;
  return flipped;
}

int Workspace::split_edges(const std::vector<MovingDirection>& directions) {
  const int split = foldless::split_edges(mesh, directions, split_settings(*this));
  if (split > 0) system.rebuild(mesh, positions, split);
  splits += split;
  return split;
}

void Workspace::refine() {
  splits += split_all_edges(mesh, split_settings(*this));
  system.rebuild(mesh, positions, mesh.edge_count());
}

int Workspace::collapse_edges(const CollapseSettings& settings) {
  const int removed = foldless::collapse_edges(mesh, settings);
  if (removed > 0) system.rebuild(mesh, positions, mesh.edge_count());
  return removed;
}

void Workspace::set_mesh(MeshPair other) {
  mesh = std::move(other);
  curvature = {};
  system.rebuild(mesh, positions, mesh.edge_count());
}

bool Workspace::snap() {
  Points u = mesh.deformed();
  for (int i = 0; i < positions.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (!positions.soft[row]) u.col(positions.vertices[row]) = positions.targets.col(i);
  }
  const Points step = u - mesh.deformed();
  if (system.objective().largest_step(mesh.deformed(), step) <= 1) return false;
  Positions held = positions;
  held.held = true;
  const double before = system.objective().value(mesh.deformed(), held).total();
  if (!(system.objective().value(u, held).total() <= kGrowthOfASnap * before)) return false;
  mesh.set_deformed(std::move(u));
  system.moved();
  return true;
}

void Workspace::take_counts(const Workspace& copy) {
  system.counters = copy.system.counters;
  system.times = copy.system.times;
  flips = copy.flips;
  splits = copy.splits;
}

void Workspace::set_energy(const EnergySettings& energy) {
  system.set_energy(energy, mesh, positions);
}

}  // namespace foldless
