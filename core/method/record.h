// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/iteration.h"
#include "core/solve/newton_system.h"
#include "core/solve/update_vertices.h"

namespace foldless {

/// The record of one update that a NewtonSystem made: energies, gradient, distortion and counters
/// at `mesh`. The place in the loops, the phase, flips, splits and seconds are the method's to
/// add. The penalty is that of `positions`, even where the system held the handles. Precondition: E
/// and ∇E of `system` are those at `mesh`.
Iteration record_of(const VertexUpdate& update, const NewtonSystem& system, const MeshPair& mesh,
                    const Positions& positions);

}  // namespace foldless
