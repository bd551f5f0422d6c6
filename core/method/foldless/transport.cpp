// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport.h"

#include <algorithm>

#include "core/energy/densities.h"

namespace foldless {
namespace {

constexpr double kAlpha = 1e4;
constexpr double kLastAlpha = 1e9;
constexpr double kAlphaFactor = 20;
constexpr int kMostStepsOfAStride = 8;
/// A handle has made its stride when less than this part of it is left.
constexpr double kArrived = 0.3;
/// A stride gains when the handles come nearer to its end by this part.
constexpr double kGain = 0.3;
constexpr int kMostStridesWithoutGain = 6;
/// ‖P‖²/D² from which the handles may be put on their targets by themselves.
constexpr double kNearEnough = 1e-4;

Points handle_points(const Workspace& workspace) {
  return held_where_they_are(workspace.positions, workspace.mesh.deformed()).targets;
}

}  // namespace

EnergySettings Transport::energy(double delta) {
  EnergySettings settings;
  settings.density = find_density("symmetric-dirichlet");
  settings.alpha = kAlpha;
  settings.beta = 0;
  settings.delta = delta;
  settings.barrier_area_weighted = true;
  settings.reference = Reference::equilateral;
  return settings;
}

Transport::Transport(Workspace& workspace, TransportPlan plan)
    : plan_(std::move(plan)),
      paths_(plan_.path, handle_points(workspace), workspace.positions.targets),
      lambda_(static_cast<std::size_t>(workspace.positions.count()), 0),
      aimed_(held_where_they_are(workspace.positions, workspace.mesh.deformed())) {
  workspace.system.set_alpha(kAlpha);
  begin_stride(workspace);
}

Progress Transport::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(aimed_, token);
  if (update.cancelled) return Progress::cancelled;
  const auto has_arrived = [&](int i) {
    return distance_to_go(workspace, i) < kArrived * plan_.stride;
  };
  const std::vector<int>& group = plan_.groups[group_];
  if (++steps_of_stride_ < kMostStepsOfAStride && !std::ranges::all_of(group, has_arrived) &&
      update.step_infinity_norm > 1e-3 * plan_.stride)
    return Progress::running;
  return end_stride(workspace);
}

// Handles on straight paths go on by themselves; those that turn keep step, so that what lies
// between them turns like a rigid body.
void Transport::begin_stride(Workspace& workspace) {
  const std::vector<int>& group = plan_.groups[group_];
  steps_of_stride_ = 0;
  lag_ = 0;
  const auto has_arrived = [&](int i) {
    return distance_to_go(workspace, i) < kArrived * plan_.stride;
  };
  const bool keep_step = plan_.path == PathKind::turning;
  const bool all_arrived = std::ranges::all_of(group, has_arrived);
  double longest = 0;
  for (const int i : group) longest = std::max(longest, paths_.length(i));
  for (const int i : group) {
    double& lambda = lambda_[static_cast<std::size_t>(i)];
    const double length = keep_step ? longest : paths_.length(i);
    if (length == 0) lambda = 1;
    if (lambda < 1 && (keep_step ? all_arrived : has_arrived(i)))
      lambda = std::min(1.0, lambda + plan_.stride / length);
    aimed_.targets.col(i) = paths_.at(i, lambda);
    lag_ += distance_to_go(workspace, i);
  }
}

double Transport::distance_to_go(const Workspace& workspace, int handle) const {
  const int v = aimed_.vertices[static_cast<std::size_t>(handle)];
  return (workspace.mesh.deformed().col(v) - aimed_.targets.col(handle)).norm();
}

Progress Transport::end_stride(Workspace& workspace) {
  const std::vector<int>& group = plan_.groups[group_];
  double left = 0;
  bool is_home = true;
  for (const int i : group) {
    left += distance_to_go(workspace, i);
    is_home &= lambda_[static_cast<std::size_t>(i)] >= 1 &&
               distance_to_go(workspace, i) < kArrived * plan_.stride;
  }
  if (is_home) {
    if (group_ + 1 < plan_.groups.size()) {
      ++group_;
      strides_without_gain_ = 0;
      begin_stride(workspace);
      return Progress::running;
    }
    if (workspace.error() <= kNearEnough && workspace.snap()) return Progress::arrived;
    const double alpha = workspace.system.objective().settings().alpha;
    if (alpha < kLastAlpha) {
      workspace.system.set_alpha(kAlphaFactor * alpha);
      steps_of_stride_ = 0;
      return Progress::running;
    }
  }
  if (left > (1 - kGain) * lag_ || is_home) {
    if (++strides_without_gain_ > kMostStridesWithoutGain) return Progress::locked;
    split_ahead(workspace);
  } else {
    strides_without_gain_ = 0;
  }
  begin_stride(workspace);
  return Progress::running;
}

void Transport::split_ahead(Workspace& workspace) {
  std::vector<MovingDirection> directions;
  for (const int i : plan_.groups[group_]) {
    const int v = aimed_.vertices[static_cast<std::size_t>(i)];
    const Vec2 direction = aimed_.targets.col(i) - workspace.mesh.deformed().col(v);
    if (direction.norm() > kArrived * plan_.stride * 0.5) directions.push_back({v, direction});
  }
  workspace.split_edges(directions);
}

}  // namespace foldless
