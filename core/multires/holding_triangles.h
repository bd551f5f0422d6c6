// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/multires/coarsen.h"

namespace foldless {

/// For every vertex of a fine mesh the triangle of the coarse one that holds it at rest; −1 for
/// vertices that no triangle uses. The meshes have one rest domain, to rounding, which may lie over
/// itself: the search follows the edges of the fine mesh from the vertices that both have. Edges of
/// the coarse mesh may have been flipped and split since it was made.
std::vector<int> holding_triangles(const CoarseMesh& coarse, const MeshPair& fine);

}  // namespace foldless
