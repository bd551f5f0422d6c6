// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless.h"

#include <algorithm>
#include <utility>

#include "core/mesh/quality.h"
#include "core/method/foldless/infeasible.h"
#include "core/method/foldless/transport_plans.h"
#include "core/method/record.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

constexpr double kOffTarget = 1e-6;
constexpr int kMostSplitRounds = 3;
constexpr double kGainOfASplitRound = 0.9;
/// Of a mesh of at most so many triangles,
constexpr int kLargestUncrushed = 2000;
/// so many other ways are tried where triangles are crushed.
constexpr int kAttemptsWhenCrushed = 6;

double largest_distortion(const MeshPair& mesh) {
  return quality_of(mesh.triangles(), mesh.rest(), mesh.deformed()).max_conformal_distortion;
}

EnergySettings own_energy(const Problem& problem) {
  EnergySettings settings;
  settings.density = problem.energy;
  settings.alpha = problem.parameters.alpha;
  settings.beta = problem.parameters.beta.value_or(Foldless::kBeta);
  settings.delta = problem.parameters.delta;
  settings.barrier_area_weighted = true;
  return settings;
}

Workspace workspace_of(const MeshPair& mesh, const Problem& problem, const EnergySettings& energy) {
  Positions positions = positions_of(problem.handles);
  NewtonSystem system(energy, mesh, positions);
  return {mesh, std::move(positions), std::move(system), problem.parameters.eta,
          problem.parameters.condition_test};
}

/// Vertices that came with the original mesh stay, and so do those before a handle, whose indices
/// must not change.
int first_removable_vertex(const Problem& problem) {
  int first = problem.original ? problem.original->vertices : problem.mesh.vertex_count();
  for (const Handle& handle : problem.handles) first = std::max(first, handle.vertex + 1);
  return first;
}

}  // namespace

Foldless::Foldless(Problem problem, const CoarseSettings& dense)
    : initial_(problem.mesh),
      first_removable_(first_removable_vertex(problem)),
      energy_(own_energy(problem)),
      work_(workspace_of(problem.mesh, problem, energy_)),
      held_regions_(foldless::held_regions(initial_, work_.positions)),
      stage_(first_stage()),
      other_ways_(energy_, true) {
  work_.fixed_boundary = boundary_vertices(held_regions_, work_.positions);
  if (work_.system.objective().unknowns().count() == 0) outcome_ = Outcome::gradient;
  if (outcome_ || work_.error() == 0) return;
  if (std::optional<Coarse> coarse = Coarse::of(problem, dense)) stage_ = std::move(*coarse);
}

Foldless::Stage Foldless::first_stage() {
  if (work_.error() > 0) return Pursue(work_);
  return Tidy(work_, first_removable_);
}

std::unique_ptr<Method> Foldless::clone() const { return std::make_unique<Foldless>(*this); }

void Foldless::set_targets(const Points& targets) {
  work_.positions.targets = targets;
  work_.system.set_lagging(true);
  is_drag_ = true;
  verdict_.clear();
  satisfied_.reset();
  attempts_when_crushed_ = 0;
  stage_ = first_stage();
  split_rounds_ = 0;
  other_ways_ = OtherWays(energy_, true);
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
  if (auto* stage = std::get_if<Approach>(&stage_)) return approach(*stage, token);
  if (auto* stage = std::get_if<Attempt>(&stage_)) return attempt(*stage, token);
  if (auto* stage = std::get_if<Coarse>(&stage_)) return coarse(*stage, token);
  if (auto* stage = std::get_if<Pursue>(&stage_)) return pursue(*stage, token);
  return settle(std::get<Tidy>(stage_), token);
}

std::optional<Iteration> Foldless::approach(Approach& stage, std::stop_token token) {
  VertexUpdate update;
  const Progress progress = stage.step(work_, token, update);
  if (progress == Progress::cancelled) return std::nullopt;
  Iteration iteration = record(work_, update, work_.positions);
  iteration.phase = Phase::approach;
  if (progress == Progress::arrived) {
    work_.system.set_lagging(true);
    stage_ = Tidy(work_, first_removable_);
  }
  if (progress == Progress::locked) after_locked_approach();
  return iteration;
}

std::optional<Iteration> Foldless::attempt(Attempt& attempt, std::stop_token token) {
  VertexUpdate update;
  const Progress progress = attempt.step(token, update);
  if (progress == Progress::cancelled) return std::nullopt;
  Iteration iteration = record(attempt.work, update, attempt.work.positions);
  iteration.phase = attempt.is_transport() ? Phase::transport : Phase::approach;
  if (progress == Progress::arrived) {
    work_ = std::move(attempt.work);
    work_.set_energy(energy_);
    work_.system.set_lagging(true);
    stage_ = Tidy(work_, first_removable_);
  } else if (progress == Progress::locked) {
    after_locked_attempt(attempt);
  }
  return iteration;
}

std::optional<Iteration> Foldless::coarse(Coarse& stage, std::stop_token token) {
  Iteration iteration;
  const Progress progress = stage.step(work_, token, iteration);
  if (progress == Progress::cancelled) return std::nullopt;
  if (progress == Progress::arrived) {
    const VertexUpdate update{.mu = iteration.mu,
                              .step_length = iteration.step_length,
                              .step_infinity_norm = iteration.step_infinity_norm};
    iteration = record(work_, update, work_.positions);
  }
  inner_ = iteration.inner;
  iteration.phase = Phase::coarse;
  if (progress != Progress::running) stage_ = first_stage();
  return iteration;
}

std::optional<Iteration> Foldless::pursue(Pursue& stage, std::stop_token token) {
  VertexUpdate update;
  const Progress progress = stage.step(work_, token, update);
  if (progress == Progress::cancelled) return std::nullopt;
  Iteration iteration = record(work_, update, stage.positions());
  iteration.phase = Phase::pursue;
  if (progress == Progress::arrived) stage_ = Tidy(work_, first_removable_);
  if (progress == Progress::locked) after_locked_pursuit();
  return iteration;
}

std::optional<Iteration> Foldless::settle(Tidy& stage, std::stop_token token) {
  VertexUpdate update;
  const Progress progress = stage.step(work_, token, update);
  if (progress == Progress::cancelled) return std::nullopt;
  Iteration iteration = record(work_, update, stage.positions());
  iteration.phase = Phase::settle;
  if (progress != Progress::running) after_tidying();
  return iteration;
}

// Triangles that a pursuit pressed together lead to poor minima. The mesh of a drag goes on from
// where it is, for somebody looks at it.
void Foldless::after_locked_pursuit() {
  if (!is_drag_) {
    work_.set_mesh(initial_);
    other_ways_ = OtherWays(energy_, false);  // an approach from rest comes now
  }
  stage_ = Approach(work_);
}

// Where triangles are crushed another way may end in a better mesh; the best one stays.
void Foldless::after_tidying() {
  const bool tries_more = !is_drag_ && initial_.face_count() <= kLargestUncrushed &&
                          largest_distortion(work_.mesh) >= Tidy::kCrushed;
  if (!satisfied_ && !tries_more) {
    outcome_ = Outcome::gradient;
    return;
  }
  if (!satisfied_ || largest_distortion(work_.mesh) < largest_distortion(satisfied_->mesh))
    satisfied_ = work_;
  if (tries_more)
    begin_next_attempt();
  else
    end_satisfied();
}

void Foldless::end_satisfied() {
  satisfied_->take_counts(work_);
  work_ = *std::exchange(satisfied_, std::nullopt);
  outcome_ = Outcome::gradient;
}

void Foldless::after_locked_approach() {
  const double error = work_.error();
  if (!is_satisfied(error) && prove_infeasible()) return;
  if (!is_drag_ && work_.system.is_lagging()) {
    work_.system.set_lagging(false);
    // Once more with the steps of Newton himself: some scenes are reached only so, but hardly
    // those whose handles turn.
    const Points starts = held_where_they_are(work_.positions, initial_.rest()).targets;
    if (!turn_together(starts, work_.positions.targets)) {
      work_.set_mesh(initial_);
      stage_ = Approach(work_);
      return;
    }
  }
  const bool may_split = split_rounds_ == 0 || error < kGainOfASplitRound * locked_error_;
  locked_error_ = error;
  if (may_split && split_rounds_++ < kMostSplitRounds && split()) {
    stage_ = Approach(work_);
    return;
  }
  begin_next_attempt();
}

// Handles within the tolerance of a target that is exactly out of reach are at it.
bool Foldless::is_satisfied(double error) const {
  const double diagonal = bounding_box_diagonal(initial_.rest());
  return error <= kSatisfied * diagonal * diagonal;
}

bool Foldless::prove_infeasible() {
  const std::optional<std::string> why = why_infeasible(held_regions_, work_.positions);
  if (!why) return false;
  outcome_ = Outcome::infeasible;
  verdict_ = *why;
  return true;
}

void Foldless::after_locked_attempt(Attempt& attempt) {
  const bool is_nearer = attempt.work.error() < work_.error();
  if (attempt.is_transport()) other_ways_.take_locked(attempt.work);
  if (is_nearer && attempt.is_transport()) {
    attempt.begin_approach();
    return;
  }
  if (is_nearer)
    work_ = std::move(attempt.work);
  else
    work_.take_counts(attempt.work);
  begin_next_attempt();
}

MeshPair Foldless::at_rest() const {
  Points u = initial_.deformed();
  for (const int v : unknowns_of(initial_, work_.positions.vertices).vertex_of_node)
    u.col(v) = initial_.rest().col(v);
  return {initial_.triangles(), initial_.rest(), std::move(u)};
}

void Foldless::begin_next_attempt() {
  if (satisfied_ && attempts_when_crushed_++ >= kAttemptsWhenCrushed) {
    end_satisfied();
    return;
  }
  Workspace work = work_;
  work.set_mesh(at_rest());
  work.system.set_lagging(false);
  if (std::optional<Attempt> next = other_ways_.next(work))
    stage_ = std::move(*next);
  else if (satisfied_)
    end_satisfied();
  else
    outcome_ = Outcome::step;
}

bool Foldless::split() {
  std::vector<MovingDirection> directions;
  for (int i = 0; i < work_.positions.count(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    const int v = work_.positions.vertices[row];
    const Vec2 direction = work_.positions.targets.col(i) - work_.mesh.deformed().col(v);
    if (!work_.positions.soft[row] && direction.norm() > kOffTarget)
      directions.push_back({v, direction});
  }
  return work_.split_edges(directions) > 0;
}

Iteration Foldless::record(Workspace& work, const VertexUpdate& update,
                           const Positions& positions) {
  work.system.assemble_gradient(work.mesh.deformed(), positions);
  Iteration iteration = record_of(update, work.system, work.mesh, work.positions);
  iteration.outer = split_rounds_ + other_ways_.count();
  iteration.inner = ++inner_;
  iteration.flips = work.flips;
  iteration.splits = work.splits;
  return iteration;
}

}  // namespace foldless
