// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/placed_mesh.h"
#include "app/export/vector_pane.h"

namespace foldless {

/// The edges of a sheet.
void draw_edges(const VectorPane& pane, const PlacedMesh& mesh, std::size_t sheet,
                const ViewOptions& style);

/// The outline of a mesh, whatever its sheets.
void draw_outline(const VectorPane& pane, const PlacedMesh& mesh, const LineStyle& style);

}  // namespace foldless
