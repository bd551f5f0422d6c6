// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/construct/slits.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Whether a closed polygon bounds an immersed disk with an angle of less than 2π at every corner:
/// it then has a triangulation on its corners alone [SV92], and only then. Simple polygons that go
/// round counter-clockwise do, and many that overlap themselves. Corners are columns, three or
/// more. Exact. O(n³).
bool bounds_disk(const Points& polygon);

/// Triangles that triangulate two polygons with the same number of corners, each of which bounds a
/// disk as in bounds_disk(): a locally injective map of one disk onto the other that takes corner
/// to corner and side to side [ASS93]. The first vertices are the corners; chords of a
/// triangulation of the one that cross chords of one of the other add vertices, which is avoided
/// where it can be. Nothing where a polygon bounds no disk, or where rounding leaves a triangle
/// that is not positive.
std::optional<MeshPair> compatible_triangulation(const Points& rest, const Points& deformed);

/// The same for polygons that are disks cut open along slits, and may have full turns at their
/// tips. Larger ones than `most_corners` are not triangulated anew: their triangles i < j < k are
/// given, or nothing is made.
std::optional<MeshPair> compatible_triangulation(const SlitDisks& disks, int most_corners);

}  // namespace foldless
