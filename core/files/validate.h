// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/files/mesh_source.h"
#include "core/files/polygon_soup.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// Refuses triangles that do not make an oriented manifold: an edge of more than two triangles, an
/// edge whose two triangles lie on the same side of it, a vertex where fans of triangles touch
/// (bow tie). Throws Error naming the first offender and the count. Precondition: indices in range.
void check_connectivity(const Triangles& triangles, int vertex_count, const MeshSource& source);

/// Whether boundary vertices may overlap themselves, as published methods leave them in M′.
enum class BoundaryOverlaps { refused, allowed };

/// Refuses positions (2 × #V) beyond ±1e75 or all within 1e-75, and those that are not locally
/// injective: a triangle of area zero, a clockwise
/// triangle, an interior vertex covered more than once, a boundary vertex whose angles add up to 2π
/// or more; all exact. Throws Error. Precondition: the triangles passed check_connectivity().
void check_positions(const Triangles& triangles, const Points& points, const MeshSource& source,
                     BoundaryOverlaps allowed = BoundaryOverlaps::refused);

/// Makes a mesh that the solver can take, or throws Error naming the first offender and the count:
/// checks the connectivity and the positions, and refuses mixed orientation. Triangles that are
/// all clockwise are turned over; that, and vertices without a triangle, are told in the notices.
TriangleSoup validated(TriangleSoup mesh);

}  // namespace foldless
