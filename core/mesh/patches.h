// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Free vertices of a mesh that hang together, with all triangles at them: what can be moved while
/// the rest stays.
struct Patch {
  Triangles triangles;        ///< 3 × #F of the patch, manifold, of its own vertices
  std::vector<int> vertices;  ///< in the mesh, by vertex of the patch; one that is not free comes
                              ///< once for every fan of triangles that the patch has at it
};

/// Adds to marked vertices all that are within `rings` edges of them.
void grow(std::vector<bool>& is_marked, const Triangles& triangles, int rings);

/// The patches of a mesh whose free vertices are marked, in the order of their first triangles; two
/// have no triangle in common. Precondition: oriented manifold triangles, of no boundary vertex
/// that is free. O(#F log #F).
std::vector<Patch> patches(const Triangles& triangles, const std::vector<bool>& is_free);

}  // namespace foldless
