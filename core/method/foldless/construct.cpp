// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/construct.h"

#include <optional>
#include <utility>

#include "core/construct/held_disk.h"
#include "core/method/foldless/approach.h"
#include "core/method/foldless/open_up.h"
#include "core/method/foldless/pursue.h"

namespace foldless {
namespace constructing {

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
  co_await open_up(other);
  if (!other.is_feasible()) co_return Progress::locked;
  Progress progress = Progress::arrived;
  if (other.error() > 0) progress = co_await pursue(other);
  if (progress == Progress::locked) progress = co_await approach(other, FactorUse::lagged);
  if (progress == Progress::arrived) work = std::move(other);
  co_return progress;
}

}  // namespace foldless
