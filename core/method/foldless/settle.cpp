// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

namespace foldless {
namespace {

/// Converged: the quadratic model promises less than this part of E.
constexpr double kSmallDecrement = 1e-4;
constexpr double kSmallStep = 1e-9;
constexpr int kMostSteps = 300;
/// Flips at the minimum start the descent again when they gain more than this part of E.
constexpr double kGainOfFlips = 1e-3;

}  // namespace

Settle::Settle(Workspace& workspace) : held_(workspace.positions) {
  held_.held = true;
  workspace.curvature = {};
}

Progress Settle::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(held_, token);
  if (update.cancelled) return Progress::cancelled;
  const double energy = energy_of(workspace);
  const bool is_converged =
      update.decrement <= kSmallDecrement * energy || update.step_infinity_norm < kSmallStep;
  if (++steps_ >= kMostSteps) return Progress::arrived;
  if (!is_converged) return Progress::running;
  workspace.flip_edges();
  const bool is_gain = energy - energy_of(workspace) > kGainOfFlips * energy;
  return is_gain ? Progress::running : Progress::arrived;
}

double Settle::energy_of(const Workspace& workspace) const {
  return workspace.system.objective().value(workspace.mesh.deformed(), held_).total();
}

}  // namespace foldless
