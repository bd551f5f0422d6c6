// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/strides.h"

#include <algorithm>

namespace foldless {
namespace striding {

/// A handle has made its stride when less than this part of it is left.
constexpr double kArrived = 0.3;
/// Edges are split ahead of a handle that is farther off than this part of a stride.
constexpr double kSplitFrom = 0.15;
/// A stride gains when the handles come nearer to its end by this part.
constexpr double kGain = 0.3;
constexpr int kMostStridesWithoutGain = 6;

}  // namespace striding

Strides::Strides(const Workspace& work, const TransportPlan& plan)
    : work_(work),
      stride_(plan.stride * work.settings->diagonal),
      paths_(plan.path, work.handles(), work.constraints.targets),
      lambda_(static_cast<std::size_t>(work.constraints.count()), 0),
      aims_(work.handles()) {}

void Strides::begin(const std::vector<int>& group) {
  const bool keep_step = paths_.kind() == PathKind::turning;
  const bool have_all_arrived = have_arrived(group);
  double longest = 0;
  for (const int i : group) longest = std::max(longest, paths_.length(i));
  for (const int i : group) {
    double& lambda = lambda_[static_cast<std::size_t>(i)];
    const double length = keep_step ? longest : paths_.length(i);
    if (length == 0) lambda = 1;
    if (lambda < 1 && (keep_step ? have_all_arrived : has_arrived(i)))
      lambda = std::min(1.0, lambda + stride_ / length);
    aims_.col(i) = paths_.at(i, lambda);
  }
}

bool Strides::have_arrived(const std::vector<int>& group) const {
  return std::ranges::all_of(group, [this](int i) { return has_arrived(i); });
}

bool Strides::are_home(const std::vector<int>& group) const {
  return std::ranges::all_of(
      group, [this](int i) { return lambda_[static_cast<std::size_t>(i)] >= 1 && has_arrived(i); });
}

double Strides::distance(const std::vector<int>& group) const {
  double sum = 0;
  for (const int i : group) sum += to_aim(i).norm();
  return sum;
}

std::vector<MovingDirection> Strides::directions(const std::vector<int>& group) const {
  std::vector<MovingDirection> directions;
  for (const int i : group)
    if (to_aim(i).norm() > striding::kSplitFrom * stride_)
      directions.push_back({work_.constraints.vertices[static_cast<std::size_t>(i)], to_aim(i)});
  return directions;
}

bool Strides::has_arrived(int handle) const {
  return to_aim(handle).norm() < striding::kArrived * stride_;
}

Vec2 Strides::to_aim(int handle) const {
  const int v = work_.constraints.vertices[static_cast<std::size_t>(handle)];
  return aims_.col(handle) - work_.mesh.deformed().col(v);
}

bool Patience::gains(double before, double after) {
  const bool gains = after <= (1 - striding::kGain) * before;
  strides_without_gain_ = gains ? 0 : strides_without_gain_ + 1;
  return gains;
}

bool Patience::has_run_out() const {
  return strides_without_gain_ > striding::kMostStridesWithoutGain;
}

}  // namespace foldless
