// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/update_vertices.h"

#include "core/linear/shared_vectors.h"
#include "core/solve/line_search.h"
#include "core/solve/newton_step.h"

namespace foldless {

VertexUpdate update_vertices(DampedSystem& system, MeshPair& mesh, const Energy& energy,
                             const std::stop_token& token) {
  if (system.factor().is_exact()) {
    system.assemble_gradient(energy, mesh.deformed());
    return move_vertices(system, mesh, energy, 0);
  }
  system.assemble(energy, mesh.deformed());
  const std::optional<double> mu = system.factorize_damped(false, token);
  if (!mu) return {.cancelled = token.stop_requested()};
  return move_vertices(system, mesh, energy, *mu);
}

VertexUpdate move_vertices(NewtonSystem& system, MeshPair& mesh, const Energy& energy, double mu) {
  VertexUpdate update = move_along(newton_step(system), system, mesh, energy);
  update.mu = mu;
  return update;
}

VertexUpdate move_along(const Points& step, NewtonSystem& system, MeshPair& mesh,
                        const Energy& energy) {
  VertexUpdate update;
  StageTimer timer(system.effort().times.line_search);
  const double slope = foldless::slope(system, step);
  if (!(slope < 0)) return update;
  update.decrement = -0.5 * slope;
  LineSearchResult found = line_search(system.objective(), energy,
                                       {mesh.deformed(), step, system.energy().total(), slope});
  if (found.step_length == 0) return update;
  update.step_length = found.step_length;
  update.step_infinity_norm = largest_difference(found.u, mesh.deformed());
  mesh.set_deformed(std::move(found.u));
  system.factor().outdate();
  ++system.effort().updates;
  return update;
}

}  // namespace foldless
