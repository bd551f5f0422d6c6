// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/lim.h"

#include <algorithm>

#include "core/mesh/injective.h"
#include "core/method/map_words.h"
#include "core/method/record.h"
#include "core/method/remeshing_assisted.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

/// Targets that are a part t of the way from where the handles are.
Positions part_way(const Positions& positions, const Points& u, double t) {
  Positions part = held_where_they_are(positions, u);
  part.targets = t * positions.targets + (1 - t) * part.targets;
  return part;
}

}  // namespace

Lim::Lim(Problem problem)
    : mesh_(std::move(problem.mesh)),
      parameters_(problem.parameters),
      diagonal_(bounding_box_diagonal(mesh_.rest())),
      positions_(positions_of(problem.handles)),
      system_(energy_settings({mesh_, problem.energy, {}, parameters_}), mesh_, positions_) {
  if (system_.objective().unknowns().count() == 0) outcome_ = Outcome::gradient;
}

std::unique_ptr<Method> Lim::clone() const { return std::make_unique<Lim>(*this); }

void Lim::set_targets(const Points& targets) {
  positions_.targets = targets;
  step_scale_ = 1;
  inner_ = 0;
  verdict_.clear();
  if (system_.objective().unknowns().count() > 0) outcome_.reset();
}

std::optional<Iteration> Lim::step(std::stop_token token) {
  if (outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  const VertexUpdate moved = update(token);
  if (!moved.cancelled) {
    ++inner_;
    system_.assemble_gradient(mesh_.deformed(), positions_);
    outcome_ = convergence(moved);
    if (!outcome_ && inner_ >= parameters_.inner_iterations) outcome_ = Outcome::iteration_limit;
    if (outcome_) verdict_ = words_on(check_injectivity(mesh_.triangles(), mesh_.deformed()));
  }
  seconds_ += thread_seconds() - start;
  if (moved.cancelled) return std::nullopt;
  Iteration iteration = record_of(moved, system_, mesh_, positions_);
  iteration.inner = inner_;
  iteration.seconds = seconds_;
  return iteration;
}

VertexUpdate Lim::update(std::stop_token token) {
  system_.assemble(mesh_.deformed(), positions_);
  const std::optional<double> mu = system_.factorize_damped(false, token);
  if (!mu) return {.cancelled = token.stop_requested()};
  // ∇²E does not depend on the targets, so its factor serves those of the sub-step as well.
  const double t = 1 / (1 + *mu * *mu);
  const Positions sub_step = part_way(positions_, mesh_.deformed(), t);
  system_.assemble_gradient(mesh_.deformed(), sub_step);
  VertexUpdate moved = move_along(system_.newton_step(), sub_step);
  moved.mu = *mu;
  return moved;
}

// The scale of the step is kept from one iteration to the next: halved until E falls, doubled when
// it fell at the first trial.
VertexUpdate Lim::move_along(const Points& step, const Positions& positions) {
  StageTimer timer(system_.times.line_search);
  const double energy = system_.objective().value(mesh_.deformed(), positions).total();
  const double largest = step.cwiseAbs().maxCoeff();
  const double smallest_move = parameters_.step_tolerance * diagonal_;
  for (bool first = true; step_scale_ * largest >= smallest_move; first = false) {
    Points trial = mesh_.deformed() + step_scale_ * step;
    if (system_.objective().value(trial, positions).total() < energy) {
      const VertexUpdate moved{.step_length = step_scale_,
                               .step_infinity_norm = step_scale_ * largest};
      mesh_.set_deformed(std::move(trial));
      system_.moved();
      ++system_.counters.updates;
      if (first) step_scale_ = std::min(1.0, 2 * step_scale_);
      return moved;
    }
    step_scale_ /= 2;
  }
  return {};
}

std::optional<Outcome> Lim::convergence(const VertexUpdate& update) const {
  if (system_.gradient().squaredNorm() < parameters_.gradient_tolerance) return Outcome::gradient;
  if (update.step_infinity_norm < parameters_.step_tolerance * diagonal_) return Outcome::step;
  return std::nullopt;
}

}  // namespace foldless
