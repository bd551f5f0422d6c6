// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/descend.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

/// Rounding may leave a clamped matrix just short of positive definite, and far from it where
/// triangles are nearly crushed.
constexpr double kLeastShift = 1e-9;
constexpr double kLargestShift = 1e13;
constexpr double kShiftFactor = 100;

/// After a step shorter than this ∇²E is factorized anew: with an old factor many more such steps
/// follow, where the map is about to fold.
constexpr double kShortStep = 0.1;

constexpr int kMostFullStepsWanted = 8;
constexpr double kFirstPart = 0.5;
constexpr double kLeastPart = 0.25;

void after_partly_clamped(CurvatureChoice& choice, double step_length) {
  choice.full_steps_wanted = 1;
  if (step_length == 1) choice.clamping = choice.clamping > kLeastPart ? choice.clamping / 2 : 0;
}

void after_failure(CurvatureChoice& choice) {
  choice.clamping = 1;
  choice.full_steps = 0;
  choice.full_steps_wanted = std::min(2 * choice.full_steps_wanted, kMostFullStepsWanted);
}

void after_clamped(CurvatureChoice& choice, double step_length) {
  choice.full_steps = step_length == 1 ? choice.full_steps + 1 : 0;
  if (choice.full_steps >= choice.full_steps_wanted) choice.clamping = kFirstPart;
}

VertexUpdate step_along(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                        const Points& step, double mu) {
  const VertexUpdate update = move_along(system, mesh, positions, step, mu);
  if (update.step_length < kShortStep) system.outdate_factor();
  return update;
}

/// Nothing where ∇²E as assembled is not positive definite.
std::optional<Points> step_if_definite(NewtonSystem& system) {
  if (std::optional<LaggedStep> lagged = system.lagged_newton_step()) {
    if (lagged->is_indefinite) return std::nullopt;
    return std::move(lagged->step);
  }
  if (!system.factorize(0)) return std::nullopt;
  return system.newton_step();
}

}  // namespace

std::optional<double> factorize_clamped(NewtonSystem& system, std::stop_token token,
                                        double last_shift) {
  for (double mu = std::max(kLeastShift, last_shift / kShiftFactor); mu < kLargestShift;
       mu *= kShiftFactor) {
    if (token.stop_requested()) return std::nullopt;
    if (system.factorize(mu)) return mu;
  }
  return std::nullopt;
}

VertexUpdate descend(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                     CurvatureChoice& choice, std::stop_token token) {
  if (choice.clamping < 1) {
    system.assemble(mesh.deformed(), positions, choice.clamping);
    if (const std::optional<Points> step = step_if_definite(system)) {
      VertexUpdate update = step_along(system, mesh, positions, *step, 0);
      update.clamping = choice.clamping;
      after_partly_clamped(choice, update.step_length);
      return update;
    }
    if (token.stop_requested()) return {.cancelled = true};
    after_failure(choice);
  }
  system.assemble(mesh.deformed(), positions, 1);
  double mu = 0;
  std::optional<LaggedStep> step = system.lagged_newton_step();
  if (!step || step->is_indefinite) {
    const std::optional<double> shift = factorize_clamped(system, token, choice.last_shift);
    if (!shift) return {.cancelled = token.stop_requested()};
    choice.last_shift = mu = *shift;
    step = LaggedStep{system.newton_step()};
  }
  VertexUpdate update = step_along(system, mesh, positions, step->step, mu);
  update.clamping = 1;
  after_clamped(choice, update.step_length);
  return update;
}

}  // namespace foldless
