// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// The most corners of a boundary; all of this takes less than a second then.
inline constexpr int kMostCornersOfADisk = 500;

/// A mesh with another map, and other triangles, of a component that is a disk: one that takes the
/// vertices along its boundary, `loop`, with the disk on their left, to `targets` (2 × #loop),
/// whatever the map of `mesh` is. The rest positions of all vertices stay; those inside are
/// connected anew: a Delaunay triangulation of those within each triangle of
/// compatible_triangulation(), whose crossings become vertices, the last ones.
/// Nothing where `targets` bound no disk, nor where the loop has more corners than above, nor where
/// rounding leaves a mesh that is not proved locally injective.
std::optional<MeshPair> with_held_disk(const MeshPair& mesh, const std::vector<int>& loop,
                                       const Points& targets);

}  // namespace foldless
