// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// Of which disks cut_to_handles() knows where the whole boundary goes.
enum class KnownBoundary {
  held,    ///< all of it is held by handles that are not soft
  at_rest  ///< also others: what is not held stays where it is at rest until all handles arrived
};

/// How many handles are inside of disks of that kind for which cut_to_handles() would construct a
/// map: with one of its handles off its target, and not too many inside.
int handles_to_cut(const MeshPair& rest, const Constraints& constraints, KnownBoundary boundary);

/// The stage for handles inside of disks that have to make room for each other: disks of that kind
/// get a map that has their handles on their targets, made by with_pinned_disk(), whatever was in
/// the way, and are opened up while vertices that nobody needs go. Handles elsewhere are then
/// carried and approached as always. Locks where rounding is in the way, a triangle leaves the
/// feasible set, or handles elsewhere lock. `choice`: of the class of maps, see with_pinned_disk().
/// Precondition: `work` is at rest.
Steps<Progress> cut_to_handles(Workspace& work, KnownBoundary boundary, int choice = 0);

}  // namespace foldless
