// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/descend.h"

namespace foldless {
namespace {

/// Rounding may leave a clamped matrix just short of positive definite.
constexpr double kFirstShift = 1e-9;
constexpr double kLargestShift = 1e3;
constexpr double kShiftFactor = 100;

/// The shift that made the clamped ∇²E positive definite; nothing when cancelled or hopeless.
std::optional<double> factorize_clamped(NewtonSystem& system, std::stop_token token) {
  for (double mu = kFirstShift; mu < kLargestShift; mu *= kShiftFactor) {
    if (token.stop_requested()) return std::nullopt;
    if (system.factorize(mu)) return mu;
  }
  return std::nullopt;
}

}  // namespace

VertexUpdate descend(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                     Curvature& curvature, std::stop_token token) {
  if (curvature == Curvature::exact) {
    system.assemble(mesh.deformed(), positions);
    if (system.factorize(0)) return move_vertices(system, mesh, positions, 0);
    if (token.stop_requested()) return {.cancelled = true};
    curvature = Curvature::clamped;
  }
  system.assemble(mesh.deformed(), positions, Curvature::clamped);
  const std::optional<double> mu = factorize_clamped(system, token);
  if (!mu) return {.cancelled = token.stop_requested()};
  const VertexUpdate update = move_vertices(system, mesh, positions, *mu);
  if (update.step_length == 1) curvature = Curvature::exact;
  return update;
}

}  // namespace foldless
