// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// The edges of a triangle mesh as pairs of vertex indices.
struct MeshEdges {
  std::vector<std::uint32_t> interior;  ///< edges of two triangles, two indices an edge
  std::vector<std::uint32_t> boundary;  ///< edges of one triangle
};

/// `triangles` holds three vertex indices a triangle. O(#F log #F).
MeshEdges mesh_edges(std::span<const std::uint32_t> triangles);

}  // namespace foldless
