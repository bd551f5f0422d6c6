// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/construct.h"

#include <optional>
#include <utility>

#include "core/construct/held_disk.h"
#include "core/energy/densities.h"
#include "core/method/foldless/approach.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/method/foldless/pursue.h"
#include "core/method/foldless/tidy.h"

namespace foldless {
namespace constructing {

constexpr int kMostOpeningSteps = 50;
/// The part of the energy that the model promises from which a map is open.
constexpr double kSmallDecrement = 1e-2;
/// A mesh of at most so many triangles is refined where one is crushed: those with three held
/// corners keep their shape whatever moves.
constexpr int kLargestRefined = 2000;

std::vector<int> vertices_of(const std::vector<int>& handles, const Constraints& constraints) {
  std::vector<int> vertices;
  vertices.reserve(handles.size());
  for (const int handle : handles)
    vertices.push_back(constraints.vertices[static_cast<std::size_t>(handle)]);
  return vertices;
}

/// Disks that `start` does not have where they are to be.
std::vector<const PrescribedRegion*> disks_to_construct(
    const MeshPair& start, const std::vector<PrescribedRegion>& regions,
    const Constraints& constraints) {
  std::vector<const PrescribedRegion*> disks;
  for (const PrescribedRegion& region : regions) {
    if (region.euler_characteristic != 1 || region.loops.size() != 1) continue;
    const std::vector<int>& loop = region.loops.front();
    const Points now = start.deformed()(Eigen::all, vertices_of(loop, constraints));
    if (now != constraints.targets(Eigen::all, loop)) disks.push_back(&region);
  }
  return disks;
}

std::optional<MeshPair> constructed(MeshPair mesh,
                                    const std::vector<const PrescribedRegion*>& disks,
                                    const Constraints& constraints) {
  for (const PrescribedRegion* disk : disks) {
    const std::vector<int>& loop = disk->loops.front();
    std::optional<MeshPair> next =
        with_held_disk(mesh, vertices_of(loop, constraints), constraints.targets(Eigen::all, loop));
    if (!next) return std::nullopt;
    mesh = *std::move(next);
  }
  return mesh;
}

/// Lowers the distortion of the triangles against their rest shapes both ways, which also opens
/// those that the chords left too narrow for the scene's energy.
EnergySettings opening_energy(const EnergySettings& scene) {
  EnergySettings settings;
  settings.density = find_density("symmetric-dirichlet");
  settings.alpha = scene.alpha;
  settings.beta = 0;
  settings.delta = 0;
  settings.gap_weight = scene.gap_weight;
  settings.barrier_area_weighted = true;
  return settings;
}

/// Until it gains little, with the handles on the boundary held.
Steps<> open_up(Workspace& work, const Energy& energy) {
  FlippingDescent descent(FactorUse::lagged);
  const auto next = [&](const std::stop_token& token) { return descent.step(work, energy, token); };
  for (int step = 0; step < kMostOpeningSteps; ++step) {
    const VertexUpdate update = co_await vertex_update(next);
    co_yield work.record(update, energy, Phase::construct);
    const double E = work.system.objective().value(energy, work.mesh.deformed()).total();
    if (update.decrement <= kSmallDecrement * E) co_return;
  }
}

}  // namespace constructing

Steps<Progress> construct(Workspace& work, const MeshPair& start,
                          const std::vector<PrescribedRegion>& regions) {
  using namespace constructing;
  const auto disks = disks_to_construct(start, regions, work.constraints);
  if (disks.empty()) co_return Progress::locked;
  Workspace other = work;
  const auto build = [&](const std::stop_token&) {
    std::optional<MeshPair> mesh = constructed(start, disks, other.constraints);
    if (!mesh) return VertexUpdate{};
    other.system.effort().splits += mesh->vertex_count() - start.vertex_count();
    other.set_mesh(*std::move(mesh));
    return VertexUpdate{.step_length = 1};
  };
  const VertexUpdate update = co_await vertex_update(build);
  if (update.step_length == 0) co_return Progress::locked;
  const Energy opening{opening_energy(work.settings->energy), held(other.constraints)};
  co_yield other.record(update, opening, Phase::construct);
  co_await open_up(other, opening);
  if (is_crushed(other.mesh) && other.mesh.face_count() <= kLargestRefined) {
    other.refine();
    co_await open_up(other, opening);
  }
  if (!other.is_feasible()) co_return Progress::locked;
  Progress progress = Progress::arrived;
  if (other.error() > 0) progress = co_await pursue(other);
  if (progress == Progress::locked) progress = co_await approach(other, FactorUse::lagged);
  if (progress == Progress::arrived) work = std::move(other);
  co_return progress;
}

}  // namespace foldless
