// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>

#include "core/solve/update_vertices.h"

namespace foldless {

/// One Newton step that carries the held handles to their targets and lets the mesh follow: with
/// K = ∇²E, its elements clamped to positive semidefinite, and δ the way of the handles h,
///
///     K_ff d_f = −∇E_f − K_fh δ
///
/// for all other unknowns f. The step as a whole is scaled by t = min(1, 0.8 t_max), t_max as in
/// line_search(), so that no triangle reaches A′ = δA on the way; at t = 1 the handles are exactly
/// on their targets. Where few triangles are in the way of more, carry_patches() may take it to its
/// end. E may rise. Where rounding alone would take a triangle beyond that, t = 0. Counts H and U.
/// Precondition: `constraints.held`.
VertexUpdate carry_handles(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                           const std::stop_token& token);

}  // namespace foldless
