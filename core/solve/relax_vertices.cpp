// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/relax_vertices.h"

namespace foldless {

std::optional<VertexUpdate> relax_vertices(DampedSystem& system, MeshPair& mesh,
                                           const Energy& energy, const std::stop_token& token) {
  // E_c pulls to where the handles are (4.2).
  const Energy relaxing{
      energy.settings,
      with_targets(energy.constraints, handle_positions(energy.constraints, mesh.deformed()))};
  system.assemble(relaxing, mesh.deformed());
  if (system.factorize_plain(token)) return std::nullopt;
  const std::optional<double> mu = system.factorize_damped(true, token);
  if (!mu) return VertexUpdate{.cancelled = token.stop_requested()};
  return move_vertices(system, mesh, relaxing, *mu);
}

}  // namespace foldless
