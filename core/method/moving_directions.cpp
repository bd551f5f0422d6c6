// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/moving_directions.h"

namespace foldless {
namespace {

/// Eq. 12 but for the factor of −∂E_c/∂v.
Vec2 direction_of(const ConvergenceInformation& information, int v, const Vec2& to_target,
                  const Vec2& last_step) {
  if (information.outcome == Outcome::gradient) return to_target;
  if (information.is_last_step_small) return -information.gradient.segment<2>(2 * v);
  return last_step;
}

}  // namespace

std::vector<MovingDirection> moving_directions(const Constraints& constraints, const Points& u,
                                               const ConvergenceInformation& information,
                                               double tolerance) {
  std::vector<MovingDirection> directions;
  for (int i = 0; i < constraints.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int v = constraints.vertices[k];
    const Vec2 to_target = constraints.targets.col(i) - u.col(v);
    if (constraints.soft[k] || to_target.norm() <= tolerance) continue;
    const Vec2 last_step = information.handles_before.cols() > i
                               ? Vec2(u.col(v) - information.handles_before.col(i))
                               : Vec2(Vec2::Zero());
    const Vec2 direction = direction_of(information, v, to_target, last_step);
    // A direction that has vanished points to the target.
    directions.push_back({v, direction.isZero(0) ? to_target : direction});
  }
  return directions;
}

}  // namespace foldless
