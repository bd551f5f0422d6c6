// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/solve/update_vertices.h"

namespace foldless {

/// One step of Newton's method without damping: with the exact ∇²E where that is positive definite,
/// else with the curvature of every element clamped. `curvature` is remembered from step to step:
/// after a clamped one the exact ∇²E is tried again only when a full step was possible. Moves the
/// deformed positions of `mesh`; they stay feasible on the whole way. Counts H and U.
VertexUpdate descend(NewtonSystem& system, MeshPair& mesh, const Positions& positions,
                     Curvature& curvature, std::stop_token token);

}  // namespace foldless
