// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/transport.h"

#include <limits>
#include <utility>

#include "core/energy/densities.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/method/foldless/settle.h"
#include "core/method/foldless/snap.h"
#include "core/method/foldless/strides.h"

namespace foldless {
namespace transporting {

constexpr double kAlpha = 1e4;
constexpr double kLastAlpha = 1e9;
constexpr double kAlphaFactor = 20;
constexpr int kMostStepsOfAStride = 8;
/// A stride has ended when no vertex moves by more than this part of it.
constexpr double kSmallStep = 1e-3;

/// At the ends of the paths, under the largest penalty, what is in the way is split so often.
constexpr int kMostSplitsAtHome = 6;

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
  Patience patience;
  while (true) {
    strides.begin(group);
    const double before = strides.distance(group);
    co_await make_stride(carrier, group);
    if (strides.are_home(group)) co_return true;
    if (patience.gains(before, strides.distance(group))) continue;
    if (patience.has_run_out()) co_return false;
    work.split_edges(strides.directions(group));
  }
}

/// Puts handles that are at the ends of their paths exactly on their targets, under a penalty that
/// grows; then splits what is in the way.
Steps<Progress> press_home(Carrier& carrier, const std::vector<int>& group) {
  auto& [work, strides, energy, descent] = carrier;
  double& alpha = energy.settings.alpha;
  for (int tries = 0;;) {
    if (is_near(work) && snap(work, energy.settings)) {
      co_yield [&carrier](Iteration& last) { carrier.work.measure_again(last, carrier.energy); };
      co_return Progress::arrived;
    }
    if (alpha < kLastAlpha) {
      alpha *= kAlphaFactor;
    } else {
      if (++tries > kMostSplitsAtHome) co_return Progress::locked;
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
