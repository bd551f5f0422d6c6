// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/foldless/cut_to_handles.h"

#include <optional>
#include <utility>

#include "core/method/foldless/approach.h"
#include "core/method/foldless/open_up.h"
#include "core/method/foldless/pursue.h"

namespace foldless {
namespace cutting {

/// A map is opened in rounds of so many steps,
constexpr int kStepsOfARound = 6;
constexpr int kMostRounds = 10;
/// before each of which vertices go that raise the energy by no more than this part,
constexpr double kRiseOfAVertex = 1e-3;
/// until less than one in so many went,
constexpr int kFewOf = 50;
/// and then in so many steps.
constexpr int kLastSteps = 50;
/// σ₁/σ₂ that a vertex may leave where it was less.
constexpr double kLargestDistortion = 1e3;

// Most vertices that slits and crossings made are needed no more once the map is there.
Steps<> open_and_thin_out(Workspace& work) {
  const Energy energy = opening_energy(work);
  co_yield work.record({.step_length = 1}, energy, Phase::construct);
  for (int round = 0; round < kMostRounds; ++round) {
    const double E = work.system.objective().value(energy, work.mesh.deformed()).total();
    const int before = work.mesh.vertex_count();
    const int gone = work.collapse_edges({.energy = energy.settings,
                                          .first_removable = work.settings->first_removable,
                                          .largest_rise = kRiseOfAVertex * E,
                                          .largest_distortion = kLargestDistortion});
    co_await lower(work, energy, kStepsOfARound);
    if (kFewOf * gone < before) break;
  }
  co_await lower(work, energy, kLastSteps);
}

}  // namespace cutting

Steps<Progress> cut_to_handles(Workspace& work, CutBoundary boundary, int choice) {
  using namespace cutting;
  Workspace other = work;
  const auto build = [&](const std::stop_token&) {
    std::optional<MeshPair> mesh = cut_open(work.mesh, work.constraints, boundary, choice);
    if (!mesh) return VertexUpdate{};
    other.system.effort().splits += mesh->vertex_count() - work.mesh.vertex_count();
    other.set_mesh(*std::move(mesh));
    return VertexUpdate{.step_length = 1};
  };
  const VertexUpdate update = co_await vertex_update(build);
  if (update.step_length == 0) co_return Progress::locked;
  co_await open_and_thin_out(other);
  if (!other.is_feasible()) co_return Progress::locked;
  Progress progress = Progress::arrived;
  if (other.error() > 0) progress = co_await pursue(other);
  if (progress == Progress::locked) progress = co_await approach(other, FactorUse::lagged);
  if (progress == Progress::arrived) work = std::move(other);
  co_return progress;
}

}  // namespace foldless
