// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace foldless {

/// An edge of a triangle mesh: its vertices, the smaller first, and its triangles.
struct MeshEdge {
  std::uint32_t a = 0, b = 0;
  int triangle = -1;
  int other = -1;  ///< −1 at the boundary

  bool operator==(const MeshEdge&) const = default;
};

/// The edges of a triangle mesh, sorted by their vertices.
struct MeshEdges {
  std::vector<MeshEdge> interior;  ///< of two triangles
  std::vector<MeshEdge> boundary;  ///< of one
};

/// `triangles` holds three vertex indices a triangle. O(#F log #F).
MeshEdges mesh_edges(std::span<const std::uint32_t> triangles);

/// The edge between two vertices in a sorted list, or null.
const MeshEdge* find_edge(const std::vector<MeshEdge>& edges, std::uint32_t a, std::uint32_t b);

}  // namespace foldless
