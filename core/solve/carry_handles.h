// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
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
/// on their targets. E may rise. Where rounding alone would take a triangle beyond that, t = 0.
/// Counts H and U. Precondition: `constraints.held`.
VertexUpdate carry_handles(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                           const std::stop_token& token);

/// A carry that went only so far, for something was in its way.
struct StoppedCarry {
  const Energy& energy;
  Points before;  ///< where it began, 2 × #V
  Points step;    ///< 2 × #V
  Points end;     ///< before + step, handles at their targets
};

struct Carry {
  VertexUpdate update;
  std::optional<StoppedCarry> stopped;  ///< where t < 1
};

/// carry_handles(), and what there was to go. `energy` outlives it.
Carry carry_as_far_as_possible(NewtonSystem& system, MeshPair& mesh, const Energy& energy,
                               const std::stop_token& token);

}  // namespace foldless
