// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/solve/carry_handles.h"

namespace foldless {

/// Ends a carry where few triangles are in its way: all vertices but those within some rings of
/// these go the rest of the step, and what is round those triangles follows by itself, with its own
/// steps, each as far as its own triangles let it; nonlinear elimination [LRW96]. Handles and
/// boundary vertices go the way of the step. Nothing where that is too much of the mesh, where some
/// of it does not arrive, where a gap is in the way, or where it was stopped. `mesh` is on the
/// step, and stays where it is. Counts H and U.
std::optional<Points> carry_patches(NewtonSystem& system, const MeshPair& mesh,
                                    const StoppedCarry& carry, const std::stop_token& token);

/// carry_handles(), which patches take to its end where they can.
VertexUpdate carry_handles_and_patches(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                                       const std::stop_token& token);

}  // namespace foldless
