// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/workspace.h"

#include <utility>

#include "core/method/foldless/handles_of_components.h"
#include "core/method/record.h"
#include "core/remesh/relocate_vertices.h"
#include "core/remesh/split_distorted.h"

namespace foldless {
namespace workspace {

/// Of an edge that is split. [D]
constexpr double kShortestHalf = 1e-5;
/// The part of the weights of barriers that is left where handles are held.
constexpr double kBarriersWhereHeld = 0.05;

SplitSettings split_settings(const RunSettings& settings) {
  return {.shortest_edge = kShortestHalf * settings.diagonal,
          .delta = settings.energy.delta,
          .fixed_boundary = settings.fixed_boundary};
}

}  // namespace workspace

Workspace::Workspace(MeshPair start, Constraints handles, const RunSettings& run_settings,
                     Effort& effort)
    : mesh(std::move(start)),
      constraints(std::move(handles)),
      system(mesh, constraints, effort),
      settings(&run_settings),
      parts(handles_of_components(mesh, constraints)) {}

Energy Workspace::held_energy() const {
  using workspace::kBarriersWhereHeld;
  Energy energy{settings->energy, held(constraints)};
  energy.settings.beta *= kBarriersWhereHeld;
  energy.settings.gap_weight *= kBarriersWhereHeld;
  return energy;
}

bool Workspace::is_feasible() const {
  const Points& u = mesh.deformed();
  return system.objective().is_feasible(settings->energy, u, u);
}

int Workspace::flip_edges(const EnergySettings& energy, double least_gain) {
  int flipped = 0;
  {
    StageTimer timer(system.effort().times.flip);
    flipped =
        foldless::flip_edges(mesh, {energy, settings->eta, settings->condition_test, least_gain});
  }
  if (flipped > 0) system.follow_flips(mesh);
  system.effort().flips += flipped;
  return flipped;
}

int Workspace::split_edges(const std::vector<MovingDirection>& directions) {
  const int split = foldless::split_edges(mesh, directions, workspace::split_settings(*settings));
  if (split > 0) system.rebuild(mesh, constraints);
  system.effort().splits += split;
  return split;
}

void Workspace::refine() {
  system.effort().splits += split_all_edges(mesh, workspace::split_settings(*settings));
  system.rebuild(mesh, constraints);
}

int Workspace::split_distorted(double least, int most) {
  SplitSettings split_settings = workspace::split_settings(*settings);
  split_settings.most_splits = most;
  const int split = foldless::split_distorted(mesh, least, split_settings);
  if (split > 0) system.rebuild(mesh, constraints);
  system.effort().splits += split;
  return split;
}

int Workspace::collapse_edges(const CollapseSettings& collapse) {
  const int removed = foldless::collapse_edges(mesh, collapse);
  if (removed > 0) system.rebuild(mesh, constraints);
  return removed;
}

VertexUpdate Workspace::relocate_vertices(const EnergySettings& energy, double least_gain,
                                          const std::stop_token& token) {
  MeshPair moved = mesh;
  const double fall =
      foldless::relocate_vertices(moved, {energy, settings->first_removable, least_gain}, token);
  if (token.stop_requested()) return {.cancelled = true};
  const double largest = (moved.deformed() - mesh.deformed()).cwiseAbs().maxCoeff();
  if (fall > 0) {
    mesh = std::move(moved);
    system.rebuild(mesh, constraints);
  }
  return {.step_length = 1, .step_infinity_norm = largest};
}

void Workspace::set_mesh(MeshPair other) {
  other.set_stiffness(mesh.stiffness());
  mesh = std::move(other);
  system.rebuild(mesh, constraints);
}

void Workspace::set_flipped_mesh(MeshPair other) {
  mesh = std::move(other);
  system.follow_flips(mesh);
}

Iteration Workspace::record(const VertexUpdate& update, const Energy& energy, Phase phase) {
  const Energy real = with_real_targets(energy);
  system.assemble_gradient(real, mesh.deformed());
  Effort& effort = system.effort();
  Iteration iteration = record_of(update, system, mesh, real);
  iteration.outer = effort.rounds;
  iteration.inner = ++effort.steps;
  iteration.phase = phase;
  return iteration;
}

void Workspace::measure_again(Iteration& last, const Energy& energy) {
  const Energy real = with_real_targets(energy);
  system.assemble_gradient(real, mesh.deformed());
  measure(last, system, mesh, real);
}

Energy Workspace::with_real_targets(const Energy& energy) const {
  Energy real{energy.settings, constraints};
  real.constraints.held = energy.constraints.held;
  return real;
}

}  // namespace foldless
