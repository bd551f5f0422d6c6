// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/relax_vertices.h"

namespace foldless {

std::optional<VertexUpdate> relax_vertices(NewtonSystem& system, MeshPair& mesh,
                                           const Positions& positions, std::stop_token token) {
  const Positions held = held_where_they_are(positions, mesh.deformed());
  system.assemble(mesh.deformed(), held);
  if (system.factorize_plain()) return std::nullopt;
  const std::optional<double> mu = system.factorize_damped(true, token);
  if (!mu) return VertexUpdate{.cancelled = token.stop_requested()};
  return move_vertices(system, mesh, held, *mu);
}

}  // namespace foldless
