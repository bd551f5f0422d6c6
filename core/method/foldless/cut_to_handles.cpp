// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/cut_to_handles.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/construct/held_disk.h"
#include "core/construct/pinned_disk.h"
#include "core/mesh/boundary.h"
#include "core/method/foldless/approach.h"
#include "core/method/foldless/open_up.h"
#include "core/method/foldless/prescribed_regions.h"
#include "core/method/foldless/pursue.h"

namespace foldless {
namespace cutting {

/// Of handles inside; a second of slits.
constexpr std::size_t kMostInside = 200;

/// A map is opened in rounds of so many steps,
constexpr int kStepsOfARound = 6;
constexpr int kMostRounds = 10;
/// before each of which vertices go that raise the energy by no more than this part,
constexpr double kRiseOfAVertex = 1e-3;
/// until less than one in so many went,
constexpr int kFewOf = 50;
/// and then in so many steps.
constexpr int kLastSteps = 50;
/// σ₁/σ₂ that a vertex may leave where it was less.
constexpr double kLargestDistortion = 1e3;

/// What a disk has to be constructed with.
struct PinnedHandles {
  PinnedVertices vertices;
  Points targets;
};

std::vector<int> vertices_of(const std::vector<int>& handles, const Constraints& constraints) {
  std::vector<int> vertices;
  vertices.reserve(handles.size());
  for (const int handle : handles)
    vertices.push_back(constraints.vertices[static_cast<std::size_t>(handle)]);
  return vertices;
}

/// With handles, the last ones, that hold what is free of the boundary.
Constraints with_boundary_held(const MeshPair& rest, Constraints constraints) {
  const auto neighbours = boundary_neighbours(rest.triangles(), rest.vertex_count());
  const std::vector<bool> is_held = have_hard_handles(constraints, rest.vertex_count());
  const Eigen::Index handles = constraints.targets.cols();
  for (int v = 0; v < rest.vertex_count(); ++v) {
    const auto place = static_cast<std::size_t>(v);
    if (neighbours[place].are_there() && !is_held[place]) constraints.vertices.push_back(v);
  }
  constraints.soft.resize(constraints.vertices.size(), false);
  constraints.targets.conservativeResize(Eigen::NoChange, constraints.count());
  for (Eigen::Index i = handles; i < constraints.targets.cols(); ++i)
    constraints.targets.col(i) =
        rest.deformed().col(constraints.vertices[static_cast<std::size_t>(i)]);
  return constraints;
}

std::vector<PinnedHandles> disks_to_cut(const MeshPair& rest, const Constraints& handles,
                                        KnownBoundary boundary) {
  const Constraints constraints =
      boundary == KnownBoundary::held ? handles : with_boundary_held(rest, handles);
  std::vector<PinnedHandles> disks;
  bool has_any = boundary == KnownBoundary::held;
  for (const PrescribedRegion& region : prescribed_regions(rest, constraints)) {
    const std::size_t inside = region.inside.size();
    if (region.euler_characteristic != 1 || region.loops.size() != 1 || inside == 0 ||
        inside > kMostInside ||
        region.loops.front().size() > static_cast<std::size_t>(kMostCornersOfADisk))
      continue;
    const std::vector<int>& loop = region.loops.front();
    std::vector<int> pinned = loop;
    pinned.insert(pinned.end(), region.inside.begin(), region.inside.end());
    Points targets = constraints.targets(Eigen::all, pinned);
    const Points now = rest.deformed()(Eigen::all, vertices_of(pinned, constraints));
    if (targets == now) continue;
    if (std::ranges::any_of(loop, [&](int handle) { return handle >= handles.count(); }))
      has_any = true;
    disks.push_back({{vertices_of(loop, constraints), vertices_of(region.inside, constraints)},
                     std::move(targets)});
  }
  if (!has_any) disks.clear();
  return disks;
}

std::optional<MeshPair> cut(MeshPair mesh, const std::vector<PinnedHandles>& disks, int choice) {
  for (const auto& [vertices, targets] : disks) {
    std::optional<MeshPair> next = with_pinned_disk(mesh, vertices, targets, choice);
    if (!next) return std::nullopt;
    mesh = *std::move(next);
  }
  return mesh;
}

// Most vertices that slits and crossings made are needed no more once the map is there.
Steps<> open_and_thin_out(Workspace& work) {
  const Energy energy = opening_energy(work);
  co_yield work.record({.step_length = 1}, energy, Phase::construct);
  for (int round = 0; round < kMostRounds; ++round) {
    const double E = work.system.objective().value(energy, work.mesh.deformed()).total();
    const int before = work.mesh.vertex_count();
    const int gone = work.collapse_edges({.energy = energy.settings,
                                          .first_removable = work.settings->first_removable,
                                          .largest_rise = kRiseOfAVertex * E,
                                          .largest_distortion = kLargestDistortion});
    co_await lower(work, energy, kStepsOfARound);
    if (kFewOf * gone < before) break;
  }
  co_await lower(work, energy, kLastSteps);
}

}  // namespace cutting

int handles_to_cut(const MeshPair& rest, const Constraints& constraints, KnownBoundary boundary) {
  std::size_t count = 0;
  for (const cutting::PinnedHandles& disk : cutting::disks_to_cut(rest, constraints, boundary))
    count += disk.vertices.inside.size();
  return static_cast<int>(count);
}

Steps<Progress> cut_to_handles(Workspace& work, KnownBoundary boundary, int choice) {
  using namespace cutting;
  Workspace other = work;
  const auto build = [&](const std::stop_token&) {
    std::optional<MeshPair> mesh =
        cut(work.mesh, disks_to_cut(work.mesh, work.constraints, boundary), choice);
    if (!mesh) return VertexUpdate{};
    other.system.effort().splits += mesh->vertex_count() - work.mesh.vertex_count();
    other.set_mesh(*std::move(mesh));
    return VertexUpdate{.step_length = 1};
  };
  const VertexUpdate update = co_await vertex_update(build);
  if (update.step_length == 0) co_return Progress::locked;
  co_await open_and_thin_out(other);
  if (!other.is_feasible()) co_return Progress::locked;
  Progress progress = Progress::arrived;
  if (other.error() > 0) progress = co_await pursue(other);
  if (progress == Progress::locked) progress = co_await approach(other, FactorUse::lagged);
  if (progress == Progress::arrived) work = std::move(other);
  co_return progress;
}

}  // namespace foldless
