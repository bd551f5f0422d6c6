// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>

#include "core/solve/update_vertices.h"

namespace foldless {

/// RelaxVertices (4.2), one of its steps: with the handles held where they are, a damped Newton
/// step that lowers E_d + E_b and so improves the condition of ∇²E. Nothing when ∇²E is positive
/// definite already; the relaxation has ended then and the factor serves the next update.
std::optional<VertexUpdate> relax_vertices(DampedSystem& system, MeshPair& mesh,
                                           const Energy& energy, const std::stop_token& token);

}  // namespace foldless
