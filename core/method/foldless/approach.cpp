// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/approach.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

constexpr double kFirstAlpha = 10;
constexpr double kAlphaFactor = 10;
constexpr double kLastAlpha = 5e7;
/// A way of a handle from which the weakest penalty is right. [D]
constexpr double kLongWay = 0.1;

/// A stage of α has done its work when no vertex moves more than this, or when the model promises
/// less than this part of E.
constexpr double kSmallStep = 1e-3;
constexpr double kSmallDecrement = 1e-2;

/// ‖P‖²/D² from which the handles may be put on their targets by themselves.
constexpr double kNearEnough = 1e-4;

constexpr int kMostMultiplierSteps = 8;
constexpr double kMultipliersBelow = 1e-5;

/// Stalled: ‖P‖² fell by less than this part in so many steps.
constexpr double kGainOfAWatch = 0.25;
constexpr int kStepsOfAWatch = 25;

/// A short way needs no detour: the start is the stiffer, with the square, the shorter the way.
double first_alpha(const Workspace& workspace) {
  const Points handles =
      held_where_they_are(workspace.positions, workspace.mesh.deformed()).targets;
  if (handles.cols() == 0) return kFirstAlpha;
  const double way = (workspace.positions.targets - handles).colwise().norm().maxCoeff();
  const double shortness = kLongWay / std::max(way, kLongWay * 1e-4);
  return std::clamp(kFirstAlpha * shortness * shortness, kFirstAlpha, kLastAlpha);
}

}  // namespace

Approach::Approach(Workspace& workspace) : aimed_(workspace.positions) {
  start_alpha(workspace, first_alpha(workspace));
}

void Approach::start_alpha(Workspace& workspace, double alpha) {
  alpha_ = alpha;
  workspace.system.set_alpha(alpha);
  watched_error_ = workspace.error();
  watched_steps_ = 0;
}

Progress Approach::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(aimed_, token);
  return update.cancelled ? Progress::cancelled : after_step(workspace, update);
}

Progress Approach::after_step(Workspace& workspace, const VertexUpdate& update) {
  const double error = workspace.error();
  if (error <= kNearEnough && workspace.snap()) return Progress::arrived;
  const EnergyTerms terms = workspace.system.objective().value(workspace.mesh.deformed(), aimed_);
  bool is_settled =
      update.step_infinity_norm < kSmallStep || update.decrement < kSmallDecrement * terms.total();
  if (++watched_steps_ >= kStepsOfAWatch) {
    if (error > (1 - kGainOfAWatch) * watched_error_) {
      if (alpha_ >= kLastAlpha) return Progress::locked;
      is_settled = true;
    }
    watched_error_ = error;
    watched_steps_ = 0;
  }
  if (alpha_ >= kLastAlpha) return at_full_penalty(workspace, error, is_settled);
  if (is_settled) start_alpha(workspace, std::min(kLastAlpha, kAlphaFactor * alpha_));
  return Progress::running;
}

// The reaction of the mesh keeps the handles off their targets by multipliers / 2α.
Progress Approach::at_full_penalty(Workspace& workspace, double error, bool is_settled) {
  if (!is_settled) return Progress::running;
  if (error > kMultipliersBelow || multiplier_steps_ >= kMostMultiplierSteps)
    return Progress::running;  // the watch decides
  ++multiplier_steps_;
  for (int i = 0; i < aimed_.count(); ++i)
    aimed_.targets.col(i) -=
        workspace.mesh.deformed().col(aimed_.vertices[static_cast<std::size_t>(i)]) -
        workspace.positions.targets.col(i);
  return Progress::running;
}

}  // namespace foldless
