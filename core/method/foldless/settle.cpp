// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

#include <algorithm>
#include <cmath>

#include "core/energy/conformal_square.h"

namespace foldless {
namespace {

/// Converged: the quadratic model promises less than this part of E, the more the nearer a full
/// step was to Newton's, which leaves the less; at most
constexpr double kSmallDecrement = 2e-4;
/// after a full step with the exact ∇²E, which squares what is left.
constexpr double kSmallDecrementOfNewton = 1e-2;
constexpr double kSmallStep = 1e-9;
constexpr int kMostSteps = 300;
/// Flips at the minimum start the descent again when they gain more than this part of E.
constexpr double kGainOfFlips = 1e-2;
/// Triangles that a transport crushed can make the step with them useless.
constexpr int kMostFailures = 3;

bool is_converged(const VertexUpdate& update, double energy) {
  const bool is_full = update.step_length == 1;
  const double small = is_full
                           ? std::min(kSmallDecrement / update.clamping, kSmallDecrementOfNewton)
                           : kSmallDecrement;
  return update.decrement <= small * energy || update.step_infinity_norm < kSmallStep;
}

/// K.
double conformal_sum(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise())
    sum += conformal_square_value(deformation_gradient(mesh.rest(), mesh.deformed(), t));
  return sum;
}

}  // namespace

Settle::Settle(Workspace& workspace, double exponent)
    : exponent_(exponent), held_(workspace.positions) {
  held_.held = true;
  workspace.curvature = {};
}

// E Kᵉ falls with every step that lowers E + w K for w = ε E / K: the logarithm is concave.
Progress Settle::step(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  if (!energy_) energy_ = energy_of(workspace);
  const double weight = exponent_ * *energy_ / conformal_sum(workspace.mesh);
  workspace.system.set_conformal_weight(is_plain_ ? 0 : weight);
  const Progress progress = descend(workspace, token, update);
  workspace.system.set_conformal_weight(0);
  return progress;
}

Progress Settle::descend(Workspace& workspace, std::stop_token token, VertexUpdate& update) {
  update = workspace.descend(held_, token);
  if (update.cancelled) return Progress::cancelled;
  if (++steps_ >= kMostSteps) return Progress::arrived;
  if (update.step_length == 0 && !is_plain_) {
    ++failures_;
    is_plain_ = true;
    return Progress::running;
  }
  is_plain_ = failures_ >= kMostFailures;
  const double energy = energy_of(workspace);
  energy_ = energy;
  if (!is_converged(update, energy)) return Progress::running;
  workspace.flip_edges();
  energy_ = energy_of(workspace);
  const bool is_gain = energy - *energy_ > kGainOfFlips * energy;
  return is_gain ? Progress::running : Progress::arrived;
}

double Settle::energy_of(const Workspace& workspace) const {
  return workspace.system.objective().value(workspace.mesh.deformed(), held_).total();
}

double Settle::merit_of(const Workspace& workspace) const {
  const double mean = conformal_sum(workspace.mesh) / workspace.mesh.face_count();
  return energy_of(workspace) * std::pow(mean, exponent_);
}

}  // namespace foldless
