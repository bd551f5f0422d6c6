// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/energy/constraints.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Of which components a map to the handles is constructed.
enum class CutBoundary {
  held,  ///< disks whose whole boundary is held by handles that are not soft
  free   ///< those with a vertex at the boundary that is not: all of the boundary goes where it may
};

/// How many handles cut_open() would put on their targets in components of that kind, those
/// with one of them off its target and not too many of them: those inside of disks whose boundary
/// is held, all of the others.
int handles_to_cut(const MeshPair& rest, const Constraints& constraints, CutBoundary boundary);

/// A mesh at rest with a map of these components that has their handles on their targets, whatever
/// was in the way: with_pinned_disk(), with_free_domain(). Beside a free boundary those that are
/// held are cut as well, for handles may have to make room in both. `choice`: of the class of maps,
/// see pinned_map(). Nothing where one of them makes nothing.
std::optional<MeshPair> cut_open(MeshPair rest, const Constraints& constraints,
                                 CutBoundary boundary, int choice);

}  // namespace foldless
