// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Makes a vertex at a point of a triangle (barycentric, ≥ 0, sum 1) by splitting rest and deformed
/// triangle alike, so that the map stays what it is. Next to an edge the edge is split; next to a
/// corner, or where rounding would make a triangle of either mesh invalid or shrink one to A′/A ≤
/// `delta`, nothing is split. Returns the vertex that is at or nearest to the point.
int insert_vertex(MeshPair& mesh, int triangle, const Eigen::Vector3d& barycentric, double delta);

}  // namespace foldless
