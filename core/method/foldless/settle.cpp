// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

namespace foldless {
namespace {

/// Converged: the quadratic model promises less than this part of E,
constexpr double kSmallDecrement = 2e-4;
/// or less than this, and the exact model was followed all the way: that squares what is left.
constexpr double kSmallDecrementOfNewton = 1e-2;
constexpr double kSmallStep = 1e-9;
constexpr int kMostSteps = 300;
/// Flips at the minimum start the descent again when they gain more than this part of E.
constexpr double kGainOfFlips = 1e-2;

bool is_converged(const VertexUpdate& update, double energy) {
  const bool is_newton = update.mu == 0 && update.step_length == 1;
  return update.decrement <= (is_newton ? kSmallDecrementOfNewton : kSmallDecrement) * energy ||
         update.step_infinity_norm < kSmallStep;
}

}  // namespace

Settle::Settle(Workspace& workspace) : held_(workspace.positions) {
  held_.held = true;
  workspace.curvature = {};
}

Progress Settle::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(held_, token);
  if (update.cancelled) return Progress::cancelled;
  const double energy = energy_of(workspace);
  if (++steps_ >= kMostSteps) return Progress::arrived;
  if (!is_converged(update, energy)) return Progress::running;
  workspace.flip_edges();
  const bool is_gain = energy - energy_of(workspace) > kGainOfFlips * energy;
  return is_gain ? Progress::running : Progress::arrived;
}

double Settle::energy_of(const Workspace& workspace) const {
  return workspace.system.objective().value(workspace.mesh.deformed(), held_).total();
}

}  // namespace foldless
