// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The order in which triangles are drawn, as indices: later ones lie on top. Where a mesh overlaps
/// itself, one sheet lies on the other as a whole, because triangles are ordered by their distance
/// over the mesh from the vertex that is the farthest out along the longer side of the rest mesh's
/// box. That vertex does not change with flips. O(#V + #F log #F).
std::vector<int> drawing_order(const Triangles& triangles, const Points& rest);

}  // namespace foldless
