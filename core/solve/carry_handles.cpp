// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/carry_handles.h"

#include <algorithm>
#include <utility>

#include "core/solve/descend.h"
#include "core/solve/line_search.h"

namespace foldless {
namespace {

/// δ as displacements of all vertices, 2 × #V.
Points way_of_handles(const MeshPair& mesh, const Positions& positions) {
  Points way = Points::Zero(2, mesh.vertex_count());
  for (int i = 0; i < positions.count(); ++i) {
    if (!positions.is_eliminated(i)) continue;
    const int v = positions.vertices[static_cast<std::size_t>(i)];
    way.col(v) = positions.targets.col(i) - mesh.deformed().col(v);
  }
  return way;
}

/// u + t·step; at t = 1 the handles are where they should be to the last bit.
Points moved(const MeshPair& mesh, const Positions& positions, const Points& step, double t) {
  Points u = mesh.deformed() + t * step;
  if (t < 1) return u;
  for (int i = 0; i < positions.count(); ++i)
    if (positions.is_eliminated(i))
      u.col(positions.vertices[static_cast<std::size_t>(i)]) = positions.targets.col(i);
  return u;
}

}  // namespace

VertexUpdate carry_handles(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                           std::stop_token token) {
  system.assemble(mesh.deformed(), positions, 1);
  const Points way = way_of_handles(mesh, positions);
  std::optional<LaggedStep> lagged = system.lagged_carrying_step(mesh.deformed(), way);
  VertexUpdate update;
  if (!lagged || lagged->is_indefinite) {
    const std::optional<double> mu = factorize_clamped(system, token);
    if (!mu) return {.cancelled = token.stop_requested()};
    update.mu = *mu;
    lagged = LaggedStep{system.carrying_step(mesh.deformed(), way)};
  }
  const Points& step = lagged->step;
  StageTimer timer(system.times.line_search);
  const double t =
      std::min(1.0, kFirstTrial * system.objective().largest_step(mesh.deformed(), step));
  Points u = moved(mesh, positions, step, t);
  update.step_length = t;
  update.step_infinity_norm = (u - mesh.deformed()).cwiseAbs().maxCoeff();
  mesh.set_deformed(std::move(u));
  system.moved();
  ++system.counters.updates;
  return update;
}

}  // namespace foldless
