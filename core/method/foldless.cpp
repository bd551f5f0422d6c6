// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless.h"

#include <cmath>

#include "core/method/record.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

/// β per unit rest area: independent of the number of triangles, unlike the paper's.
constexpr double kBeta = 5;
constexpr double kShortestEdge = 1e-5;
constexpr int kMostSplitRounds = 3;
constexpr double kGainOfASplitRound = 0.9;

EnergySettings own_energy(const Problem& problem) {
  EnergySettings settings;
  settings.density = problem.energy;
  settings.alpha = problem.parameters.alpha;
  settings.beta = problem.parameters.beta.value_or(kBeta);
  settings.delta = problem.parameters.delta;
  settings.barrier_area_weighted = true;
  return settings;
}

Workspace workspace_of(Problem problem) {
  Positions positions = positions_of(problem.handles);
  NewtonSystem system(own_energy(problem), problem.mesh, positions);
  return {std::move(problem.mesh), std::move(positions), std::move(system), problem.parameters.eta,
          problem.parameters.condition_test};
}

}  // namespace

Foldless::Foldless(Problem problem)
    : work_(workspace_of(std::move(problem))), stage_(Approach(work_)) {
  if (work_.system.objective().unknowns().count() == 0) outcome_ = Outcome::gradient;
}

std::unique_ptr<Method> Foldless::clone() const { return std::make_unique<Foldless>(*this); }

void Foldless::set_targets(const Points& targets) {
  work_.positions.targets = targets;
  stage_ = Approach(work_);
  split_rounds_ = 0;
  if (work_.system.objective().unknowns().count() > 0) outcome_.reset();
}

std::optional<Iteration> Foldless::step(std::stop_token token) {
  if (outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  std::optional<Iteration> iteration = advance(token);
  seconds_ += thread_seconds() - start;
  if (iteration) iteration->seconds = seconds_;
  return iteration;
}

std::optional<Iteration> Foldless::advance(std::stop_token token) {
  VertexUpdate update;
  if (auto* approach = std::get_if<Approach>(&stage_)) {
    const Progress progress = approach->step(work_, token, update);
    if (progress == Progress::cancelled) return std::nullopt;
    const Iteration iteration = record(update, work_.positions, Phase::approach);
    if (progress != Progress::running) after_approach(progress);
    return iteration;
  }
  Settle& settle = std::get<Settle>(stage_);
  const Progress progress = settle.step(work_, token, update);
  if (progress == Progress::cancelled) return std::nullopt;
  const Iteration iteration = record(update, settle.positions(), Phase::settle);
  if (progress != Progress::running) outcome_ = Outcome::gradient;
  return iteration;
}

void Foldless::after_approach(Progress progress) {
  if (progress == Progress::arrived) {
    stage_ = Settle(work_);
    return;
  }
  const double error = work_.error();
  const bool may_split = split_rounds_ == 0 || error < kGainOfASplitRound * locked_error_;
  locked_error_ = error;
  if (may_split && split_rounds_++ < kMostSplitRounds && split())
    stage_ = Approach(work_);
  else
    outcome_ = Outcome::step;
}

bool Foldless::split() {
  std::vector<MovingDirection> directions;
  for (int i = 0; i < work_.positions.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const int v = work_.positions.vertices[row];
    const Vec2 direction = work_.positions.targets.col(i) - work_.mesh.deformed().col(v);
    if (!work_.positions.soft[row] && direction.norm() > 1e-6) directions.push_back({v, direction});
  }
  return work_.split_edges(directions, {.shortest_edge = kShortestEdge,
                                        .delta = work_.system.objective().settings().delta}) > 0;
}

Iteration Foldless::record(const VertexUpdate& update, const Positions& positions, Phase phase) {
  work_.system.assemble_gradient(work_.mesh.deformed(), positions);
  Iteration iteration = record_of(update, work_.system, work_.mesh, work_.positions);
  iteration.outer = split_rounds_;
  iteration.inner = ++inner_;
  iteration.phase = phase;
  iteration.flips = work_.flips;
  iteration.splits = work_.splits;
  return iteration;
}

}  // namespace foldless
