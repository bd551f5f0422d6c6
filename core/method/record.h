// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/iteration.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// The record of one update on a mesh: energies, gradient, distortion and what was spent. The place
/// in the loops, the phase and seconds are the method's to add. The penalty is that of the targets
/// even where handles are held. Precondition: `system` has E and ∇E of `energy` as they are at the
/// mesh.
Iteration record_of(const VertexUpdate& update, const NewtonSystem& system, const MeshPair& mesh,
                    const Energy& energy);

/// Brings what a record says of the mesh up to date, where a step put another one in its place
/// after the update. The same precondition.
void measure(Iteration& iteration, const NewtonSystem& system, const MeshPair& mesh,
             const Energy& energy);

}  // namespace foldless
