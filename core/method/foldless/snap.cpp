// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/snap.h"

#include <utility>

namespace foldless {
namespace snapping {

/// E_d + E_b may grow by this factor when handles are put on their targets.
constexpr double kGrowth = 1.5;
/// ‖P‖²/D² from which they may be.
constexpr double kNearEnough = 1e-4;

/// The vertices with the handles on their targets and all others where they are, 2 × #V.
Points with_handles_on_targets(const Workspace& work) {
  Points u = work.mesh.deformed();
  const Constraints& constraints = work.constraints;
  for (int i = 0; i < constraints.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (!constraints.soft[row]) u.col(constraints.vertices[row]) = constraints.targets.col(i);
  }
  return u;
}

}  // namespace snapping

bool is_near(const Workspace& work) {
  const double D = work.settings->diagonal;
  return work.error() <= snapping::kNearEnough * D * D;
}

bool snap(Workspace& work, const EnergySettings& energy) {
  const Points& now = work.mesh.deformed();
  Points u = snapping::with_handles_on_targets(work);
  const Objective& objective = work.system.objective();
  if (objective.largest_step(energy, now, u - now) <= 1 || !objective.are_gaps_open(energy, now, u))
    return false;
  const Energy held_handles{energy, held(work.constraints)};
  const double before = objective.value(held_handles, now).total();
  if (!(objective.value(held_handles, u).total() <= snapping::kGrowth * before)) return false;
  work.mesh.set_deformed(std::move(u));
  work.system.factor().outdate();
  return true;
}

}  // namespace foldless
