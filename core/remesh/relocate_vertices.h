// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/energy/energy_settings.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Which vertices may move and what that lowers.
struct RelocateSettings {
  EnergySettings energy;  ///< compared with the rest mesh
  int first_movable = 0;  ///< vertices of lower index stay where they are
  double least_gain = 0;  ///< of the energy, that a sweep has to bring for another
};

/// Moves vertices in both meshes at once, one after the other by a step of Newton's method, in
/// sweeps: where an edge was split decides how well the triangles can follow the map, and need not
/// be the middle for ever (r-adaption [TO04]). Vertices of the boundary stay, and so do outline and
/// connectivity. So does local injectivity: the areas of the triangles round a vertex are linear
/// along its step, which ends before one is used up; in the end they are proved to be positive in
/// both meshes by exact predicates, and the angles of boundary vertices do not change. Nor does a
/// triangle at rest become flatter than a thousandth of its longest edge. Returns by how much
/// distortion and barrier fell; 0 when nothing moved. Where a stop is requested it ends after the
/// vertex at hand.
double relocate_vertices(MeshPair& mesh, const RelocateSettings& settings,
                         const std::stop_token& token = {});

}  // namespace foldless
