// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/descend.h"

#include <algorithm>

namespace foldless {
namespace {

/// Rounding may leave a clamped matrix just short of positive definite, and far from it where
/// triangles are nearly crushed.
constexpr double kLeastShift = 1e-9;
constexpr double kLargestShift = 1e13;
constexpr double kShiftFactor = 100;

constexpr int kMostFullStepsWanted = 8;

void after_clamped(CurvatureChoice& choice, double step_length) {
  choice.full_steps = step_length == 1 ? choice.full_steps + 1 : 0;
  if (choice.full_steps >= choice.full_steps_wanted) choice.next = Curvature::exact;
}

void after_failure(CurvatureChoice& choice) {
  choice.next = Curvature::clamped;
  choice.full_steps = 0;
  choice.full_steps_wanted = std::min(2 * choice.full_steps_wanted, kMostFullStepsWanted);
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
  if (choice.next == Curvature::exact) {
    system.assemble(mesh.deformed(), positions);
    if (system.factorize(0)) {
      choice.full_steps_wanted = 1;
      return move_vertices(system, mesh, positions, 0);
    }
    if (token.stop_requested()) return {.cancelled = true};
    after_failure(choice);
  }
  system.assemble(mesh.deformed(), positions, Curvature::clamped);
  const std::optional<double> mu = factorize_clamped(system, token, choice.last_shift);
  if (!mu) return {.cancelled = token.stop_requested()};
  choice.last_shift = *mu;
  const VertexUpdate update = move_vertices(system, mesh, positions, *mu);
  after_clamped(choice, update.step_length);
  return update;
}

}  // namespace foldless
