// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/triangle.h"
#include "render/layer_lists.h"
#include "render/mesh_edges.h"

namespace foldless {

/// Edges of two triangles, of one, and those that the original mesh lacks.
enum class EdgeSet { interior, boundary, flipped };

/// The edges of a mesh by EdgeSet.
using EdgeLists = std::array<std::vector<MeshEdge>, 3>;

/// Of three vertex indices a triangle. Precondition: the flipped edges are edges of the mesh.
EdgeLists edge_lists(std::span<const std::uint32_t> corners, const std::vector<Edge>& flipped);

// A mesh is painted in sheets, 0 at the back; `sheets` says of every triangle to which it belongs.

/// How many sheets there are, at least one.
std::size_t count_of_sheets(const std::vector<int>& sheets);

/// The triangles of the first sheet, part by part, those of the second, …
LayerLists lists_by_part(const std::vector<int>& sheets, const std::vector<int>& parts,
                         std::size_t count_of_parts);

/// An edge of two sheets belongs to the one in front.
LayerLists edges_by_sheet(const std::vector<MeshEdge>& edges, const std::vector<int>& sheets);

/// The vertices of every sheet: each belongs to the foremost of its triangles'.
std::vector<std::vector<int>> vertices_by_sheet(std::span<const std::uint32_t> corners,
                                                const std::vector<int>& sheets);

}  // namespace foldless
