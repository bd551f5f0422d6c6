// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/lim.h"

#include <algorithm>

#include "core/mesh/injective.h"
#include "core/method/map_words.h"
#include "core/method/record.h"
#include "core/method/remeshing_assisted.h"
#include "core/method/satisfied.h"
#include "core/solve/newton_step.h"

namespace foldless {
namespace {

/// The same energy with targets that are a part t of the way from where the handles are.
Energy part_way(const Energy& energy, const Points& u, double t) {
  const auto& [settings, constraints] = energy;
  return {settings, with_targets(constraints, t * constraints.targets +
                                                  (1 - t) * handle_positions(constraints, u))};
}

}  // namespace

Lim::Lim(const Problem& problem)
    : mesh_(problem.mesh),
      parameters_(problem.parameters),
      diagonal_(bounding_box_diagonal(mesh_.rest())),
      energy_{energy_settings(problem), constraints_of(problem.handles)},
      system_(mesh_, energy_.constraints, effort()) {
  begin(solve());
}

void Lim::set_targets(const Points& targets) {
  energy_.constraints.targets = targets;
  begin(solve());
}

Steps<Outcome> Lim::solve() {
  verdict_.clear();
  double step_scale = 1;
  const auto next = [&](const std::stop_token& token) { return update(step_scale, token); };
  for (int inner = 1;; ++inner) {
    const VertexUpdate moved = co_await vertex_update(next);
    system_.assemble_gradient(energy_, mesh_.deformed());
    Iteration iteration = record_of(moved, system_, mesh_, energy_);
    iteration.inner = inner;
    co_yield iteration;
    std::optional<Outcome> ended = convergence(moved);
    if (!ended && inner >= parameters_.inner_iterations) ended = Outcome::iteration_limit;
    if (!ended) continue;
    verdict_ = words_on(check_injectivity(mesh_.triangles(), mesh_.deformed()));
    co_return *ended;
  }
}

VertexUpdate Lim::update(double& step_scale, const std::stop_token& token) {
  system_.assemble(energy_, mesh_.deformed());
  const std::optional<double> mu = system_.factorize_damped(false, token);
  if (!mu) return {.cancelled = token.stop_requested()};
  // ∇²E does not depend on the targets, so its factor serves those of the sub-step as well.
  const double t = 1 / (1 + *mu * *mu);
  const Energy sub_step = part_way(energy_, mesh_.deformed(), t);
  system_.assemble_gradient(sub_step, mesh_.deformed());
  VertexUpdate moved = move_along(newton_step(system_), sub_step, step_scale);
  moved.mu = *mu;
  return moved;
}

// The scale of the step, in (0, 1], is kept from one iteration to the next: halved until E falls,
// doubled when it fell at the first trial.
VertexUpdate Lim::move_along(const Points& step, const Energy& energy, double& step_scale) {
  StageTimer timer(effort().times.line_search);
  const double before = system_.objective().value(energy, mesh_.deformed()).total();
  const double largest = step.cwiseAbs().maxCoeff();
  const double smallest_move = parameters_.step_tolerance * diagonal_;
  for (bool first = true; step_scale * largest >= smallest_move; first = false) {
    Points trial = mesh_.deformed() + step_scale * step;
    if (system_.objective().value(energy, trial).total() < before) {
      const VertexUpdate moved{.step_length = step_scale,
                               .step_infinity_norm = step_scale * largest};
      mesh_.set_deformed(std::move(trial));
      system_.factor().outdate();
      ++effort().updates;
      if (first) step_scale = std::min(1.0, 2 * step_scale);
      return moved;
    }
    step_scale /= 2;
  }
  return {};
}

std::optional<Outcome> Lim::convergence(const VertexUpdate& update) const {
  if (system_.gradient().squaredNorm() < gradient_tolerance(parameters_, diagonal_))
    return Outcome::gradient;
  if (update.step_infinity_norm < parameters_.step_tolerance * diagonal_) return Outcome::step;
  return std::nullopt;
}

}  // namespace foldless
