// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

namespace foldless {
namespace {

/// Converged: the quadratic model promises less than this part of E.
constexpr double kSmallDecrement = 1e-7;
constexpr double kSmallStep = 1e-9;
constexpr int kMostSteps = 300;
/// Times that flips at the minimum may start the descent again.
constexpr int kMostRounds = 5;

}  // namespace

Settle::Settle(Workspace& workspace) : held_(workspace.positions) {
  held_.held = true;
  workspace.curvature = Curvature::exact;
}

Progress Settle::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(held_, token);
  if (update.cancelled) return Progress::cancelled;
  const EnergyTerms terms = workspace.system.objective().value(workspace.mesh.deformed(), held_);
  const bool is_converged =
      update.decrement <= kSmallDecrement * terms.total() || update.step_infinity_norm < kSmallStep;
  if (++steps_ >= kMostSteps) return Progress::arrived;
  if (!is_converged) return Progress::running;
  return ++rounds_ <= kMostRounds && workspace.flip_edges() > 0 ? Progress::running
                                                                : Progress::arrived;
}

}  // namespace foldless
