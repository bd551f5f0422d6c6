// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/energy/densities.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/method/foldless/settle.h"

namespace foldless {
namespace transporting {

constexpr double kAlpha = 1e4;
constexpr double kLastAlpha = 1e9;
constexpr double kAlphaFactor = 20;
constexpr int kMostStepsOfAStride = 8;
/// A handle has made its stride when less than this part of it is left.
constexpr double kArrived = 0.3;
/// Edges are split ahead of a handle that is farther off than this part of a stride.
constexpr double kSplitFrom = 0.15;
/// A stride has ended when no vertex moves by more than this part of it.
constexpr double kSmallStep = 1e-3;
/// A stride gains when the handles come nearer to its end by this part.
constexpr double kGain = 0.3;
constexpr int kMostStridesWithoutGain = 6;
/// ‖P‖²/D² from which the handles may be put on their targets by themselves.
constexpr double kNearEnough = 1e-4;

constexpr int kMostRounds = 8;
/// A round that leaves more than this part of ‖P‖² was the last.
constexpr double kGainOfARound = 0.8;

/// The energy that forgets the map: rounds every deformed triangle.
EnergySettings rounding_energy(const EnergySettings& scene) {
  EnergySettings settings;
  settings.density = find_density("symmetric-dirichlet");
  settings.alpha = kAlpha;
  settings.beta = 0;
  settings.delta = scene.delta;
  settings.gap_weight = scene.gap_weight;
  settings.barrier_area_weighted = true;
  settings.reference = Reference::equilateral;
  return settings;
}

/// Where the handles of a plan are to be at the end of a stride.
class Strides {
 public:
  Strides(const Workspace& work, const TransportPlan& plan)
      : work_(work),
        stride_(plan.stride * work.settings->diagonal),
        paths_(plan.path, work.handles(), work.constraints.targets),
        lambda_(static_cast<std::size_t>(work.constraints.count()), 0),
        aims_(work.handles()) {}

  /// The aim of all handles, 2 × #handles.
  const Points& aims() const { return aims_; }
  double stride() const { return stride_; }

  // Handles on straight paths go on by themselves; those that turn keep step, so that what lies
  // between them turns like a rigid body.
  void begin(const std::vector<int>& group) {
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

  bool have_arrived(const std::vector<int>& group) const {
    return std::ranges::all_of(group, [this](int i) { return has_arrived(i); });
  }
  /// At the ends of their paths.
  bool are_home(const std::vector<int>& group) const {
    return std::ranges::all_of(group, [this](int i) {
      return lambda_[static_cast<std::size_t>(i)] >= 1 && has_arrived(i);
    });
  }
  /// Σ of the distances to go.
  double distance(const std::vector<int>& group) const {
    double sum = 0;
    for (const int i : group) sum += to_aim(i).norm();
    return sum;
  }
  /// Of the handles that are well behind.
  std::vector<MovingDirection> directions(const std::vector<int>& group) const {
    std::vector<MovingDirection> directions;
    for (const int i : group)
      if (to_aim(i).norm() > kSplitFrom * stride_)
        directions.push_back({work_.constraints.vertices[static_cast<std::size_t>(i)], to_aim(i)});
    return directions;
  }

 private:
  bool has_arrived(int i) const { return to_aim(i).norm() < kArrived * stride_; }
  Vec2 to_aim(int i) const {
    const int v = work_.constraints.vertices[static_cast<std::size_t>(i)];
    return aims_.col(i) - work_.mesh.deformed().col(v);
  }

  const Workspace& work_;
  double stride_;  ///< [length]
  HandlePaths paths_;
  std::vector<double> lambda_;  ///< by handle: where on its path the stride ends
  Points aims_;
};

/// What carries handles on: goes from stride to stride.
struct Carrier {
  Workspace& work;
  Strides& strides;
  Energy& energy;
  FlippingDescent& descent;
};

/// Steps until the group has made its stride, or nothing moves, or there were enough of them.
Steps<> make_stride(Carrier& carrier, const std::vector<int>& group) {
  auto& [work, strides, energy, descent] = carrier;
  energy.constraints.targets = strides.aims();
  const auto next = [&carrier](const std::stop_token& token) {
    return carrier.descent.step(carrier.work, carrier.energy, token);
  };
  for (int step = 0; step < kMostStepsOfAStride; ++step) {
    const VertexUpdate update = co_await vertex_update(next);
    co_yield work.record(update, energy, Phase::transport);
    const bool is_at_rest = update.step_infinity_norm <= kSmallStep * strides.stride();
    if (is_at_rest || strides.have_arrived(group)) co_return;
  }
}

/// Carries one group of handles to the ends of their paths; false when it locks.
Steps<bool> carry_group(Carrier& carrier, const std::vector<int>& group) {
  auto& [work, strides, energy, descent] = carrier;
  for (int strides_without_gain = 0;;) {
    strides.begin(group);
    const double before = strides.distance(group);
    co_await make_stride(carrier, group);
    if (strides.are_home(group)) co_return true;
    if (strides.distance(group) <= (1 - kGain) * before) {
      strides_without_gain = 0;
      continue;
    }
    if (++strides_without_gain > kMostStridesWithoutGain) co_return false;
    work.split_edges(strides.directions(group));
  }
}

/// Puts handles that are at the ends of their paths exactly on their targets, under a penalty that
/// grows; then splits what is in the way.
Steps<Progress> press_home(Carrier& carrier, const std::vector<int>& group) {
  auto& [work, strides, energy, descent] = carrier;
  const double D = work.settings->diagonal;
  double& alpha = energy.settings.alpha;
  for (int tries = 0;;) {
    if (work.error() <= kNearEnough * D * D && work.snap(energy.settings)) {
      co_yield [&carrier](Iteration& last) { carrier.work.measure_again(last, carrier.energy); };
      co_return Progress::arrived;
    }
    if (alpha < kLastAlpha) {
      alpha *= kAlphaFactor;
    } else {
      if (++tries > kMostStridesWithoutGain) co_return Progress::locked;
      work.split_edges(strides.directions(group));
    }
    co_await make_stride(carrier, group);
    if (strides.are_home(group)) continue;
    const bool is_home = co_await carry_group(carrier, group);
    if (!is_home) co_return Progress::locked;
  }
}

/// Rounds after one that ended so.
Steps<Progress> go_on_in_rounds(Workspace& work, Progress progress) {
  double locked_error = std::numeric_limits<double>::infinity();
  for (int round = 1; progress == Progress::locked && round <= kMostRounds; ++round) {
    if (work.error() >= kGainOfARound * locked_error) break;
    locked_error = work.error();
    co_await settle(work, {.use = FactorUse::own});
    progress =
        co_await transport(work, plan_of_round(round, work.handles(), work.constraints.targets));
  }
  co_return progress;
}

}  // namespace transporting

Steps<Progress> transport(Workspace& work, TransportPlan plan) {
  using namespace transporting;
  Energy energy{rounding_energy(work.settings->energy), work.constraints};
  Strides strides(work, plan);
  FlippingDescent descent(FactorUse::own);
  Carrier carrier{work, strides, energy, descent};
  for (const std::vector<int>& group : plan.groups) {
    const bool is_home = co_await carry_group(carrier, group);
    if (!is_home) co_return Progress::locked;
  }
  co_return co_await press_home(carrier, plan.groups.back());
}

Steps<Progress> transport_in_rounds(Workspace& work, TransportPlan plan) {
  const Progress first = co_await transport(work, std::move(plan));
  co_return co_await transporting::go_on_in_rounds(work, first);
}

Steps<Progress> transport_onwards(Workspace& work) {
  co_await settle(work, {.use = FactorUse::own});
  TransportPlan plan = plan_of_round(0, work.handles(), work.constraints.targets);
  const Progress first = co_await transport(work, std::move(plan));
  co_return co_await transporting::go_on_in_rounds(work, first);
}

}  // namespace foldless
