// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// A component of a mesh, and vertices of it that are to go to targets.
struct PinnedDomain {
  std::vector<std::vector<int>> loops;  ///< its boundary, with the component on the left
  std::vector<int> pinned;              ///< inside or at the boundary
};

/// A mesh with another map, and other triangles, of such a component: one that takes the pinned
/// vertices to `targets` (2 × #pinned), whatever the map of `mesh` is, and its boundary somewhere.
/// The component is seen as a part of a rectangle that is mapped onto itself as with_pinned_disk()
/// maps a disk, and its outline engraved(). The rest positions of all vertices stay; those inside
/// are connected anew, crossings become vertices, the last ones, at the boundary too. `choice`: of
/// the class of maps, from 0 to kClassesOfPinnedDisks − 1. Nothing where the component lies over
/// itself or touches itself at rest, two targets are one, or rounding leaves a mesh that is not
/// proved locally injective.
std::optional<MeshPair> with_free_domain(const MeshPair& mesh, const PinnedDomain& domain,
                                         const Points& targets, int choice = 0);

}  // namespace foldless
