// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/open_up.h"

#include "core/energy/densities.h"
#include "core/method/foldless/flipping_descent.h"
#include "core/method/foldless/tidy.h"

namespace foldless {
namespace opening {

constexpr int kMostOpeningSteps = 50;
/// The part of the energy that the model promises from which a map is open.
constexpr double kSmallDecrement = 1e-2;
/// A mesh of at most so many triangles is refined where one is crushed: those with three held
/// corners keep their shape whatever moves.
constexpr int kLargestRefined = 2000;

/// Lowers the distortion of the triangles against their rest shapes both ways, which also opens
/// those that the chords left too narrow for the scene's energy.
EnergySettings settings_of(const EnergySettings& scene) {
  EnergySettings settings;
  settings.density = find_density("symmetric-dirichlet");
  settings.alpha = scene.alpha;
  settings.beta = 0;
  settings.delta = 0;
  settings.gap_weight = scene.gap_weight;
  settings.barrier_area_weighted = true;
  return settings;
}

}  // namespace opening

Energy opening_energy(const Workspace& work) {
  return {opening::settings_of(work.settings->energy), held(work.constraints)};
}

Steps<> lower(Workspace& work, const Energy& energy, int most_steps) {
  FlippingDescent descent(FactorUse::lagged);
  const auto next = [&](const std::stop_token& token) { return descent.step(work, energy, token); };
  for (int step = 0; step < most_steps; ++step) {
    const VertexUpdate update = co_await vertex_update(next);
    co_yield work.record(update, energy, Phase::construct);
    const double E = work.system.objective().value(energy, work.mesh.deformed()).total();
    if (update.decrement <= opening::kSmallDecrement * E) co_return;
  }
}

Steps<> open_up(Workspace& work) {
  using namespace opening;
  const Energy energy = opening_energy(work);
  co_yield work.record({.step_length = 1}, energy, Phase::construct);
  co_await lower(work, energy, kMostOpeningSteps);
  if (is_crushed(work.mesh) && work.mesh.face_count() <= kLargestRefined) {
    work.refine();
    co_await lower(work, energy, kMostOpeningSteps);
  }
}

}  // namespace foldless
