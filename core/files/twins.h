// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// How the triangles of a mesh hang together. Halfedge 3 t + k of triangle t goes from its corner
/// k to its next corner.
struct Twins {
  std::vector<int> twin;  ///< the opposite halfedge, −1 at a boundary or a defect; 3 #F entries

  int crowded_edges = 0;             ///< edges of more than two triangles
  std::optional<int> first_crowded;  ///< first halfedge of such an edge
  int first_crowded_triangles = 0;   ///< how many triangles it has
  int same_side_edges = 0;           ///< edges whose two triangles pass them in the same direction
  std::optional<int> first_same_side;  ///< first halfedge of such an edge
};

/// Pairs the halfedges of any triangles with indices in range. Nearly O(#V + #F).
Twins find_twins(const Triangles& triangles, int vertex_count);

/// Vertices where several fans of triangles meet in nothing but the vertex (bow ties), in order.
/// Precondition: no crowded and no same-side edges.
std::vector<int> bow_tie_vertices(const Triangles& triangles, const Twins& twins, int vertex_count);

/// Start and end of a halfedge.
Eigen::Vector2i halfedge_ends(const Triangles& triangles, int halfedge);

}  // namespace foldless
