// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/remeshing_assisted.h"

#include "core/method/record.h"
#include "core/method/satisfied.h"
#include "core/solve/relax_vertices.h"

namespace foldless {
namespace {

/// A round that leaves more of ‖P‖² than this has stopped gaining.
constexpr double kGainOfARound = 0.9;

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
  if (!is_small(update)) round_changed_mesh_ = true;
  system_.assemble_gradient(mesh_.deformed(), positions_);
  const std::optional<Outcome> converged = convergence(update);
  if (!converged && flip() > 0) {
    round_changed_mesh_ = true;
    system_.assemble_gradient(mesh_.deformed(), positions_);
  }
  const Iteration iteration = record(update, Phase::update);
  phase_ = Phase::relax;
  if (converged)
    end_inner_loop(*converged);
  else if (inner_ >= parameters_.inner_iterations)
    end_inner_loop(Outcome::iteration_limit);
  return iteration;
}

std::optional<Outcome> RemeshingAssisted::convergence(const VertexUpdate& update) const {
  if (system_.gradient().squaredNorm() < parameters_.gradient_tolerance) return Outcome::gradient;
  if (is_small(update)) return Outcome::step;
  return std::nullopt;
}

// Lines 10–13. Without splits another round only begins where this one ended: it can help when the
// last step was too small, or after N_in repeats that were still gaining on the targets.
void RemeshingAssisted::end_inner_loop(Outcome outcome) {
  const double error = handle_error_squared(positions_, mesh_.deformed());
  const bool is_gaining = error < kGainOfARound * round_start_error_;
  const bool next_round_can_differ = (outcome == Outcome::step && round_changed_mesh_) ||
                                     (outcome == Outcome::iteration_limit && is_gaining);
  phase_ = Phase::update;
  if (is_satisfied() || !next_round_can_differ || outer_ + 1 >= parameters_.outer_iterations) {
    outcome_ = outcome;
    return;
  }
  ++outer_;
  begin_round();
}

void RemeshingAssisted::begin_round() {
  inner_ = 0;
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
  if (flips > 0) system_.rebuild(mesh_, positions_, flips);
  flips_ += flips;
  return flips;
}

Iteration RemeshingAssisted::record(const VertexUpdate& update, Phase phase) {
  Iteration iteration = record_of(update, system_, mesh_, positions_);
  iteration.outer = outer_;
  iteration.inner = inner_;
  iteration.phase = phase;
  iteration.flips = flips_;
  return iteration;
}

}  // namespace foldless
