// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/pursue.h"

#include "core/solve/carry_handles.h"

namespace foldless {
namespace {

/// A step that brings the handles less than this part of their way is short.
constexpr double kShortCarry = 0.35;
constexpr int kMostShortSteps = 3;

}  // namespace

Pursue::Pursue(const Workspace& workspace) : held_(workspace.positions) { held_.held = true; }

Progress Pursue::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = carry_handles(workspace.system, workspace.mesh, held_, token);
  if (update.cancelled) return Progress::cancelled;
  if (update.step_length == 1) return Progress::arrived;
  workspace.flip_edges();  // an edge was in the way
  short_steps_ = update.step_length < kShortCarry ? short_steps_ + 1 : 0;
  return short_steps_ >= kMostShortSteps ? Progress::locked : Progress::running;
}

}  // namespace foldless
