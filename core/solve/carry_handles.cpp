// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_handles.h"

#include <algorithm>
#include <utility>

#include "core/linear/shared_vectors.h"
#include "core/solve/descent.h"
#include "core/solve/line_search.h"
#include "core/solve/newton_step.h"
#include "core/threads/zeros.h"

namespace foldless {
namespace {

/// δ as displacements of all vertices, 2 × #V.
Points way_of_handles(const MeshPair& mesh, const Constraints& constraints) {
  Points way = zeros<Points>(2, mesh.vertex_count());
  for (int i = 0; i < constraints.count(); ++i) {
    if (!constraints.is_eliminated(i)) continue;
    const int v = constraints.vertices[static_cast<std::size_t>(i)];
    way.col(v) = constraints.targets.col(i) - mesh.deformed().col(v);
  }
  return way;
}

/// u + t·step; at t = 1 the handles are where they should be to the last bit.
Points moved(const Points& before, const Constraints& constraints, const Points& step, double t) {
  Points u = sum_with_multiple(before, t, step);
  if (t < 1) return u;
  for (int i = 0; i < constraints.count(); ++i)
    if (constraints.is_eliminated(i))
      u.col(constraints.vertices[static_cast<std::size_t>(i)]) = constraints.targets.col(i);
  return u;
}

struct Move {
  double t;
  Points before;  ///< where the vertices were
};

Move move_along_the_step(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                         const Points& step) {
  const auto& [settings, constraints] = energy;
  StageTimer timer(system.effort().times.line_search);
  const double t_max = system.objective().largest_step(settings, mesh.deformed(), step);
  const double t = std::min(1.0, kFirstTrial * t_max);
  Points u = moved(mesh.deformed(), constraints, step, t);
  if (!system.objective().is_feasible(settings, mesh.deformed(), u)) return {0, mesh.deformed()};
  return {t, mesh.exchange_deformed(std::move(u))};
}

}  // namespace

VertexUpdate carry_handles(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                           const std::stop_token& token) {
  return carry_as_far_as_possible(system, mesh, energy, token).update;
}

Carry carry_as_far_as_possible(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                               const std::stop_token& token) {
  const auto& [settings, constraints] = energy;
  system.factor().obey(token);
  system.assemble(energy, mesh.deformed(), 1);
  const Points way = way_of_handles(mesh, constraints);
  const auto lagged_step = [&] {
    return lagged_carrying_step(system, energy.settings, mesh.deformed(), way);
  };
  std::optional<LaggedStep> lagged = lagged_step();
  if (!lagged || lagged->is_indefinite) lagged = rough_clamped_step(system, token, lagged_step);
  Carry carry;
  VertexUpdate& update = carry.update;
  if (!lagged) {
    const std::optional<double> mu = factorize_clamped(system, token);
    if (!mu) return {{.cancelled = token.stop_requested()}, std::nullopt};
    update.mu = *mu;
    lagged = LaggedStep{carrying_step(system, settings, mesh.deformed(), way)};
  }
  Points& step = lagged->step;
  Move move = move_along_the_step(system, mesh, energy, step);
  update.step_length = move.t;
  update.step_infinity_norm = largest_difference(mesh.deformed(), move.before);
  system.factor().outdate();
  ++system.effort().updates;
  if (update.step_length < 1) {
    Points end = moved(move.before, constraints, step, 1);
    carry.stopped.emplace(
        StoppedCarry{energy, std::move(move.before), std::move(step), std::move(end)});
  }
  return carry;
}

}  // namespace foldless
