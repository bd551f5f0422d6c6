// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/attempt.h"

#include <limits>
#include <utility>

#include "core/method/foldless/transport_plans.h"

namespace foldless {
namespace {

constexpr int kMostRounds = 8;
/// A round that leaves more than this part of ‖P‖² was the last.
constexpr double kGainOfARound = 0.8;

}  // namespace

Attempt::Attempt(Workspace workspace, Way way, const EnergySettings& energy, int most_rounds)
    : work(std::move(workspace)),
      energy_(energy),
      way_(std::move(way)),
      most_rounds_(most_rounds),
      locked_error_(std::numeric_limits<double>::infinity()) {}

Attempt Attempt::approach(Workspace workspace) {
  Approach way(workspace);
  const EnergySettings energy = workspace.system.objective().settings();
  return {std::move(workspace), std::move(way), energy, 0};
}

Attempt Attempt::transport(Workspace workspace, const EnergySettings& energy, TransportPlan plan,
                           bool is_persistent) {
  workspace.set_energy(Transport::energy(energy.delta));
  Transport way(workspace, std::move(plan));
  return {std::move(workspace), std::move(way), energy, is_persistent ? kMostRounds : 0};
}

Attempt Attempt::going_on(Workspace locked, const EnergySettings& energy) {
  locked.set_energy(energy);
  Settle way(locked);
  return {std::move(locked), std::move(way), energy, kMostRounds};
}

Progress Attempt::step(std::stop_token token, VertexUpdate& update) {
  const Progress progress =
      std::visit([&](auto& way) { return way.step(work, token, update); }, way_);
  if (std::holds_alternative<Settle>(way_) && progress == Progress::arrived) {
    carry_on();
    return Progress::running;
  }
  if (std::holds_alternative<Transport>(way_) && progress == Progress::locked && may_go_on()) {
    begin_round();
    return Progress::running;
  }
  return progress;
}

bool Attempt::may_go_on() const {
  return rounds_ < most_rounds_ && work.error() < kGainOfARound * locked_error_;
}

void Attempt::begin_round() {
  locked_error_ = work.error();
  ++rounds_;
  work.set_energy(energy_);
  way_ = Settle(work);
}

void Attempt::carry_on() {
  work.set_energy(Transport::energy(energy_.delta));
  const Points starts = held_where_they_are(work.positions, work.mesh.deformed()).targets;
  way_ = Transport(work, plan_of_round(rounds_, starts, work.positions.targets));
}

void Attempt::begin_approach() {
  work.set_energy(energy_);
  way_ = Approach(work);
}

}  // namespace foldless
