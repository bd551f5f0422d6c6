// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/moving_directions.h"

namespace foldless {
namespace {

Vec2 direction_of(const NewtonSystem& system, const ConvergenceInformation& information, int node,
                  const Vec2& last_step) {
  if (information.outcome == Outcome::gradient) return Vec2::Zero();
  if (information.is_last_step_small)
    return -system.gradient().segment<2>(2 * static_cast<Eigen::Index>(node));
  return last_step;
}

}  // namespace

std::vector<MovingDirection> moving_directions(const NewtonSystem& system,
                                               const Positions& positions, const Points& u,
                                               const ConvergenceInformation& information,
                                               double tolerance) {
  std::vector<MovingDirection> directions;
  for (int i = 0; i < positions.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int v = positions.vertices[k];
    const int node = system.objective().unknowns().node_of_vertex[static_cast<std::size_t>(v)];
    const Vec2 to_target = positions.targets.col(i) - u.col(v);
    if (positions.soft[k] || node < 0 || to_target.norm() <= tolerance) continue;
    const Vec2 last_step = information.handles_before.cols() > i
                               ? Vec2(u.col(v) - information.handles_before.col(i))
                               : Vec2(Vec2::Zero());
    const Vec2 direction = direction_of(system, information, node, last_step);
    // −∂E_c/∂v points to the target; so does every direction that has vanished.
    directions.push_back({v, direction.isZero(0) ? to_target : direction});
  }
  return directions;
}

}  // namespace foldless
