// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/construct/pinned_map.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Vertices of a component that is a disk, all along its boundary, with the disk on their left, and
/// some inside.
struct PinnedVertices {
  std::vector<int> loop, inside;
};

/// A mesh with another map, and other triangles, of such a component: as with_held_disk(), and the
/// vertices inside go to targets as well, those of the loop first in `targets`: by a pinned_map().
/// `choice`: of the class of maps, from 0 to kClassesOfPinnedDisks − 1; one that rounding spoils
/// gives way to others. Nothing where the targets bound no disk, those of vertices inside are not
/// within, where a disk lies over itself there, and where rounding leaves a mesh that is not proved
/// locally injective.
std::optional<MeshPair> with_pinned_disk(const MeshPair& mesh, const PinnedVertices& pinned,
                                         const Points& targets, int choice = 0);

}  // namespace foldless
