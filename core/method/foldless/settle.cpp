// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/settle.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/energy/conformal_power.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/threads/values_of_ranges.h"

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
/// Flips and moves at rest at the minimum start the descent again when they gain more than this
/// part of E.
constexpr double kGainAtTheMinimum = 1e-2;
/// Moves at rest go on while a sweep gains this part of E.
constexpr double kGainOfASweep = 1e-3;
/// Triangles that a transport crushed can make the step with K useless.
constexpr int kMostFailures = 3;

bool is_converged(const VertexUpdate& update, double energy, const Workspace& work) {
  double small = work.is_large() ? kSmallDecrementOfLarge : kSmallDecrement;
  if (update.step_length == 1) small = std::min(small / update.clamping, kSmallDecrementOfNewton);
  return update.decrement <= small * energy ||
         update.step_infinity_norm < kSmallStep * work.settings->diagonal;
}

/// Σ k^q.
double conformal_sum(const MeshPair& mesh, int q) {
  constexpr std::ptrdiff_t kTogether = 8192;  // some hundred microseconds
  const std::vector<double> sums =
      values_of_ranges(mesh.face_count(), kTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        double sum = 0;
        for (std::ptrdiff_t t = begin; t < end; ++t)
          sum += conformal_power_value(
              deformation_gradient(mesh.rest(), mesh.deformed(), mesh.triangles().col(t)), q);
        return sum;
      });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double value_of(const Workspace& work, const Energy& energy) {
  return work.system.objective().value(energy, work.mesh.deformed()).total();
}

}  // namespace settling

// E Kᵉ falls with every step that lowers E + w Σ k^q for w = 2/q ε E / (b + Σ k^q): the logarithm
// is concave.
Steps<> settle(Workspace& work, SettleSettings settings) {
  using namespace settling;
  const Energy scene = work.held_energy();
  Energy energy = scene;
  const int q = energy.settings.conformal_power = settings.power;
  const double enough = std::pow(settings.enough, q);
  double& weight = energy.settings.conformal_weight;
  FlippingDescent descent(settings.use);
  const auto next = [&](const std::stop_token& token) { return descent.step(work, energy, token); };
  double E = value_of(work, scene);
  double at_minimum = 0;
  const auto relocate = [&](const std::stop_token& token) {
    return work.relocate_vertices(energy.settings, kGainOfASweep * at_minimum, token);
  };
  int failures = 0;
  bool is_plain = false;  // the next step lowers E alone
  for (int step = 1;; ++step) {
    weight =
        is_plain ? 0 : 2.0 / q * settings.exponent * E / (enough + conformal_sum(work.mesh, q));
    const VertexUpdate update = co_await vertex_update(next);
    const bool has_failed = update.step_length == 0 && !is_plain;
    if (has_failed) ++failures;
    is_plain = has_failed || failures >= kMostFailures;
    const bool is_last = step >= kMostSteps;
    if (!has_failed) E = value_of(work, scene);
    const bool is_minimum = !has_failed && !is_last && is_converged(update, E, work);
    if (is_minimum) {
      at_minimum = value_of(work, energy);
      descent.flip(work, energy.settings);
    }
    co_yield work.record(update, scene, Phase::settle);
    if (is_last) co_return;
    if (!is_minimum) continue;
    if (work.has_vertices_of_splits()) {
      const VertexUpdate moves = co_await vertex_update(relocate);
      co_yield work.record(moves, scene, Phase::settle);
    }
    if (at_minimum - value_of(work, energy) <= kGainAtTheMinimum * at_minimum) co_return;
    E = value_of(work, scene);
  }
}

double settled_energy(const Workspace& work) {
  return settling::value_of(work, work.held_energy());
}

double merit_of(const Workspace& work, double exponent) {
  const double mean = settling::conformal_sum(work.mesh, 2) / work.mesh.face_count();
  return settled_energy(work) * std::pow(mean, exponent);
}

}  // namespace foldless
