// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/remeshing_assisted.h"

#include <cmath>
#include <limits>

#include "core/method/moving_directions.h"
#include "core/method/record.h"
#include "core/method/satisfied.h"
#include "core/solve/relax_vertices.h"

namespace foldless {
namespace {

/// A round that leaves more of ‖P‖² than this has stopped gaining.
constexpr double kGainOfARound = 0.9;
/// The inner loop of Algorithm 1 with splits ends early where ‖P‖² fell by less than this factor in
/// so many updates.
constexpr double kGainOfAWatch = 0.9;
constexpr int kUpdatesOfAWatch = 50;
/// Rounds of splits that may leave ‖P‖² as it was before they are undone.
constexpr int kMostRoundsWithoutGain = 1;
/// No split makes an edge shorter than this. [D]
constexpr double kShortestEdge = 1e-5;

double mean_rest_area(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise()) sum += signed_area(mesh.rest(), t);
  return sum / mesh.face_count();
}

}  // namespace

EnergySettings energy_settings(const Problem& problem) {
  const Parameters& p = problem.parameters;
  EnergySettings settings{problem.energy, p.alpha, p.beta.value_or(problem.energy->default_beta),
                          p.delta, true};
  if (problem.energy->paper_sums_unweighted) {
    settings.area_weighted = p.area_weighted;
    if (p.area_weighted) settings.beta *= mean_rest_area(problem.mesh);
  }
  return settings;
}

RemeshingAssisted::RemeshingAssisted(Problem problem, Remeshing remeshing)
    : mesh_(std::move(problem.mesh)),
      parameters_(problem.parameters),
      remeshing_(remeshing),
      flip_settings_{},
      diagonal_(bounding_box_diagonal(mesh_.rest())),
      positions_(positions_of(problem.handles)),
      system_(energy_settings({mesh_, problem.energy, {}, parameters_}), mesh_, positions_) {
  flip_settings_ = {system_.objective().settings(), parameters_.eta, parameters_.condition_test};
  if (system_.objective().unknowns().count() == 0) outcome_ = Outcome::gradient;
  begin_round();
}

std::unique_ptr<Method> RemeshingAssisted::clone() const {
  return std::make_unique<RemeshingAssisted>(*this);
}

void RemeshingAssisted::set_targets(const Points& targets) {
  positions_.targets = targets;
  phase_ = Phase::update;
  outer_ = 0;
  best_.reset();
  rounds_without_gain_ = 0;
  begin_round();
  if (system_.objective().unknowns().count() > 0) outcome_.reset();
}

std::optional<Iteration> RemeshingAssisted::step(std::stop_token token) {
  if (outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  std::optional<Iteration> iteration = advance(token);
  seconds_ += thread_seconds() - start;
  if (iteration) iteration->seconds = seconds_;
  return iteration;
}

// Lines 2–9 of Algorithm 1, taken apart so that one call makes one vertex update. It is entered
// after FlipEdges: RelaxVertices goes on until ∇²E is positive definite, then UpdateVertices
// follows.
std::optional<Iteration> RemeshingAssisted::advance(std::stop_token token) {
  if (phase_ == Phase::relax) {
    const auto relaxed = relax_vertices(system_, mesh_, positions_, token);
    if (relaxed && relaxed->cancelled) return std::nullopt;
    if (relaxed) return after_relaxing(*relaxed);
    phase_ = Phase::update;
  }
  if (remeshing_.splits)
    handles_before_ = held_where_they_are(positions_, mesh_.deformed()).targets;
  const VertexUpdate update = update_vertices(system_, mesh_, positions_, token);
  if (update.cancelled) return std::nullopt;
  return after_updating(update);
}

Iteration RemeshingAssisted::after_relaxing(const VertexUpdate& update) {
  if (is_small(update))
    phase_ = Phase::update;  // eq. 8: no vertex moves any more
  else
    round_changed_mesh_ = true;
  system_.assemble_gradient(mesh_.deformed(), positions_);
  return record(update, Phase::relax);
}

Iteration RemeshingAssisted::after_updating(const VertexUpdate& update) {
  ++inner_;
  is_last_step_small_ = is_small(update);
  if (!is_last_step_small_) round_changed_mesh_ = true;
  system_.assemble_gradient(mesh_.deformed(), positions_);
  std::optional<Outcome> ended = convergence(update);
  if (!ended && flip() > 0) {
    round_changed_mesh_ = true;
    system_.assemble_gradient(mesh_.deformed(), positions_);
  }
  phase_ = Phase::relax;
  if (!ended && (inner_ >= parameters_.inner_iterations || (remeshing_.splits && has_stalled())))
    ended = Outcome::iteration_limit;
  if (ended && remeshing_.splits && !is_satisfied()) go_back_to_best();
  const Iteration iteration = record(update, Phase::update);
  if (ended) end_inner_loop(*ended);
  return iteration;
}

// A watch of some updates: without it a blocked inner loop creeps on for N_in repeats before the
// edges that block it are split.
bool RemeshingAssisted::has_stalled() {
  if (inner_ % kUpdatesOfAWatch != 0) return false;
  const double error = handle_error_squared(positions_, mesh_.deformed());
  const bool stalled = error > kGainOfAWatch * watched_error_;
  watched_error_ = error;
  return stalled;
}

std::optional<Outcome> RemeshingAssisted::convergence(const VertexUpdate& update) const {
  if (system_.gradient().squaredNorm() < parameters_.gradient_tolerance) return Outcome::gradient;
  if (is_small(update)) return Outcome::step;
  return std::nullopt;
}

// Lines 10–13.
void RemeshingAssisted::end_inner_loop(Outcome outcome) {
  phase_ = Phase::update;
  if (is_satisfied() || outer_ + 1 >= parameters_.outer_iterations ||
      !prepare_next_round(outcome)) {
    outcome_ = outcome;
    return;
  }
  ++outer_;
  begin_round();
}

// Without splits another round only begins where this one ended: it can help when the last step was
// too small, or after N_in repeats that were still gaining on the targets.
bool RemeshingAssisted::prepare_next_round(Outcome outcome) {
  const double error = handle_error_squared(positions_, mesh_.deformed());
  const bool is_gaining = error < kGainOfARound * round_start_error_;
  if (remeshing_.splits)
    return rounds_without_gain_ <= kMostRoundsWithoutGain && split(outcome) > 0;
  return (outcome == Outcome::step && round_changed_mesh_) ||
         (outcome == Outcome::iteration_limit && is_gaining);
}

int RemeshingAssisted::split(Outcome outcome) {
  const double off_target = std::sqrt(kSatisfied / positions_.count()) * diagonal_;
  const auto directions =
      moving_directions(system_, positions_, mesh_.deformed(),
                        {outcome, is_last_step_small_, handles_before_}, off_target);
  const SplitSettings settings{.shortest_edge = kShortestEdge * diagonal_,
                               .delta = parameters_.delta};
  const int splits = split_edges(mesh_, directions, settings);
  if (splits > 0) system_.rebuild(mesh_, positions_, splits);
  splits_ += splits;
  return splits;
}

// Unchecked, a blocked scene grows slivers without end: a round that gained nothing on the targets
// is undone.
void RemeshingAssisted::go_back_to_best() {
  const double error = handle_error_squared(positions_, mesh_.deformed());
  const bool has_gained = !best_ || error < kGainOfARound * best_->error;
  rounds_without_gain_ = has_gained ? 0 : rounds_without_gain_ + 1;
  if (!best_ || error < best_->error) best_ = Best{mesh_, error};
  if (rounds_without_gain_ <= kMostRoundsWithoutGain || best_->error >= error) return;
  mesh_ = best_->mesh;
  system_.rebuild(mesh_, positions_, mesh_.edge_count());
  system_.assemble_gradient(mesh_.deformed(), positions_);
}

void RemeshingAssisted::begin_round() {
  inner_ = 0;
  watched_error_ = std::numeric_limits<double>::infinity();
  round_changed_mesh_ = false;
  round_start_error_ = handle_error_squared(positions_, mesh_.deformed());
}

bool RemeshingAssisted::is_small(const VertexUpdate& update) const {
  return update.step_infinity_norm < parameters_.step_tolerance * diagonal_;
}

bool RemeshingAssisted::is_satisfied() const {
  return handle_error_squared(positions_, mesh_.deformed()) <= kSatisfied * diagonal_ * diagonal_;
}

int RemeshingAssisted::flip() {
  if (!remeshing_.flips) return 0;
  int flips = 0;
  {
    StageTimer timer(system_.times.flip);
    flips = flip_edges(mesh_, system_.objective().unknowns(), flip_settings_);
  }
  if (flips > 0) system_.take_flips(mesh_, flips);
  flips_ += flips;
  return flips;
}

Iteration RemeshingAssisted::record(const VertexUpdate& update, Phase phase) {
  Iteration iteration = record_of(update, system_, mesh_, positions_);
  iteration.outer = outer_;
  iteration.inner = inner_;
  iteration.phase = phase;
  iteration.flips = flips_;
  iteration.splits = splits_;
  return iteration;
}

}  // namespace foldless
