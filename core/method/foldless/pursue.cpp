// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/pursue.h"

#include <vector>

#include "core/method/foldless/legs.h"
#include "core/solve/carry_patches.h"

namespace foldless {
namespace pursuit {

/// A step that brings the handles less than this part of their way is short.
constexpr double kShortCarry = 0.35;
constexpr int kMostShortSteps = 3;

/// Carries the handles to where they are held.
Steps<Progress> carry_to(Workspace& work, const Energy& energy) {
  const auto carry = [&](const std::stop_token& token) {
    return carry_handles_and_patches(work.system, work.mesh, energy, token);
  };
  for (int short_steps = 0; short_steps < kMostShortSteps;) {
    const VertexUpdate update = co_await vertex_update(carry);
    const bool has_arrived = update.step_length == 1;
    if (!has_arrived) work.flip_edges(energy.settings);  // an edge was in the way
    co_yield work.record(update, energy, Phase::pursue);
    if (has_arrived) co_return Progress::arrived;
    short_steps = update.step_length < kShortCarry ? short_steps + 1 : 0;
  }
  co_return Progress::locked;
}

Steps<Progress> carry_in_legs(Workspace& work, Energy& energy) {
  const std::vector<Points> legs = legs_of(work);
  for (std::size_t leg = 0; leg < legs.size(); ++leg) {
    energy.constraints.targets = legs[leg];
    const Progress progress = co_await carry_to(work, energy);
    if (progress == Progress::locked) co_return progress;
    if (leg + 1 < legs.size()) work.flip_edges(energy.settings);
  }
  co_return Progress::arrived;
}

}  // namespace pursuit

// A drag begins at a shape that is a minimum with little barrier; all of it leads on where that
// locks.
Steps<Progress> pursue(Workspace& work) {
  Energy energy = work.held_energy();
  Progress progress = co_await pursuit::carry_in_legs(work, energy);
  if (progress == Progress::locked) {
    energy = {work.settings->energy, held(work.constraints)};
    progress = co_await pursuit::carry_in_legs(work, energy);
  }
  co_return progress;
}

}  // namespace foldless
