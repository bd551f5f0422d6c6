// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

#include <algorithm>
#include <cmath>

#include "core/energy/conformal_square.h"
#include "core/method/foldless/flipping_descent.h"

namespace foldless {
namespace settling {

/// Converged: the quadratic model promises less than this part of E, the more the nearer a full
/// step was to Newton's, which leaves the less; at most
constexpr double kSmallDecrement = 2e-4;
/// after a full step with the exact ∇²E, which squares what is left.
constexpr double kSmallDecrementOfNewton = 1e-2;
/// In place of the first, of a large mesh, whose last steps cost most: a triangle in the way bounds
/// them, so that many bring what the first one promises.
constexpr double kSmallDecrementOfLarge = 2e-3;
constexpr double kSmallStep = 1e-9;  ///< [D]
constexpr int kMostSteps = 300;
/// Flips at the minimum start the descent again when they gain more than this part of E.
constexpr double kGainOfFlips = 1e-2;
/// Triangles that a transport crushed can make the step with K useless.
constexpr int kMostFailures = 3;

bool is_converged(const VertexUpdate& update, double energy, const Workspace& work) {
  double small = work.is_large() ? kSmallDecrementOfLarge : kSmallDecrement;
  if (update.step_length == 1) small = std::min(small / update.clamping, kSmallDecrementOfNewton);
  return update.decrement <= small * energy ||
         update.step_infinity_norm < kSmallStep * work.settings->diagonal;
}

/// K.
double conformal_sum(const MeshPair& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles().colwise())
    sum += conformal_square_value(deformation_gradient(mesh.rest(), mesh.deformed(), t));
  return sum;
}

double value_of(const Workspace& work, const Energy& energy) {
  return work.system.objective().value(energy, work.mesh.deformed()).total();
}

}  // namespace settling

// E Kᵉ falls with every step that lowers E + w K for w = ε E / K: the logarithm is concave.
Steps<> settle(Workspace& work, SettleSettings settings) {
  using namespace settling;
  const Energy scene = work.held_energy();
  Energy energy = scene;
  double& weight = energy.settings.conformal_weight;
  FlippingDescent descent(settings.use);
  const auto next = [&](const std::stop_token& token) { return descent.step(work, energy, token); };
  double E = value_of(work, scene);
  int failures = 0;
  bool is_plain = false;  // the next step lowers E alone
  for (int step = 1;; ++step) {
    weight = is_plain ? 0 : settings.exponent * E / conformal_sum(work.mesh);
    const VertexUpdate update = co_await vertex_update(next);
    const bool has_failed = update.step_length == 0 && !is_plain;
    if (has_failed) ++failures;
    is_plain = has_failed || failures >= kMostFailures;
    bool is_settled = step >= kMostSteps;
    if (!has_failed && !is_settled) {
      E = value_of(work, scene);
      if (is_converged(update, E, work)) {
        const double before = value_of(work, energy);
        descent.flip(work, energy.settings);
        is_settled = before - value_of(work, energy) <= kGainOfFlips * before;
        E = value_of(work, scene);
      }
    }
    co_yield work.record(update, scene, Phase::settle);
    if (is_settled) co_return;
  }
}

double settled_energy(const Workspace& work) {
  return settling::value_of(work, work.held_energy());
}

double merit_of(const Workspace& work, double exponent) {
  const double mean = settling::conformal_sum(work.mesh) / work.mesh.face_count();
  return settled_energy(work) * std::pow(mean, exponent);
}

}  // namespace foldless
