// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/flipping_descent.h"

#include "core/method/foldless/relax_patches.h"
#include "core/solve/line_search.h"

namespace foldless {
namespace flipping_descent {

/// Flipping on every step is slower, never on full steps locks.
constexpr double kShortStep = 0.5;
constexpr int kStepsBetweenFlips = 3;
/// Flips of little gain wait for the end of the descent: each call that flips costs an analysis.
constexpr double kLeastGainWhileHeld = 2e-3;

}  // namespace flipping_descent

VertexUpdate FlippingDescent::step(Workspace& work, const Energy& energy,
                                   const std::stop_token& token) {
  using namespace flipping_descent;
  const Points before = work.is_large() ? work.mesh.deformed() : Points();
  const VertexUpdate update = descent_.step(work.system, work.mesh, energy, token);
  if (update.cancelled) return update;
  const bool is_short = update.step_length < kShortStep;
  if (work.is_large() && is_short && update.step_length > 0) {
    const Points step = (work.mesh.deformed() - before) / update.step_length;
    relax_patches(
        work, energy,
        work.system.objective().triangles_in_way(energy.settings, before, step, 1 / kFirstTrial),
        token);
  }
  ++steps_since_flips_;
  if (is_short || steps_since_flips_ >= kStepsBetweenFlips) {
    work.flip_edges(energy.settings, energy.constraints.held ? kLeastGainWhileHeld : 0);
    steps_since_flips_ = 0;
  }
  return update;
}

void FlippingDescent::flip(Workspace& work, const EnergySettings& energy) {
  work.flip_edges(energy);
  steps_since_flips_ = 0;
}

}  // namespace foldless
