// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/update_vertices.h"

#include "core/solve/line_search.h"

namespace foldless {

VertexUpdate update_vertices(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                             std::stop_token token) {
  if (system.has_plain_factor()) {
    system.assemble_gradient(mesh.deformed(), positions);
    return move_vertices(system, mesh, positions, 0);
  }
  system.assemble(mesh.deformed(), positions);
  const std::optional<double> mu = system.factorize_damped(false, token);
  if (!mu) return {.cancelled = token.stop_requested()};
  return move_vertices(system, mesh, positions, *mu);
}

VertexUpdate move_vertices(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                           double mu) {
  return move_along(system, mesh, positions, system.newton_step(), mu);
}

VertexUpdate move_along(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                        const Points& step, double mu) {
  VertexUpdate update{.mu = mu};
  StageTimer timer(system.times.line_search);
  const double slope = system.slope(step);
  if (!(slope < 0)) return update;
  update.decrement = -0.5 * slope;
  LineSearchResult found = line_search(system.objective(), positions,
                                       {mesh.deformed(), step, system.energy().total(), slope});
  if (found.step_length == 0) return update;
  update.step_length = found.step_length;
  update.step_infinity_norm = (found.u - mesh.deformed()).cwiseAbs().maxCoeff();
  mesh.set_deformed(std::move(found.u));
  system.moved();
  ++system.counters.updates;
  return update;
}

}  // namespace foldless
