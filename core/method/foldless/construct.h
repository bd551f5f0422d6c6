// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/prescribed_regions.h"
#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for disks with their whole boundary held: each of `regions` that is one, and whose
/// boundary `start` does not have on its targets, gets a map that does, made by with_held_disk(),
/// whatever `work` came to, and is opened up under the symmetric Dirichlet energy. Handles inside
/// are then carried and approached as elsewhere. `work` becomes that mesh where it arrives, and
/// stays as it is where it locks: there is nothing to construct, rounding is in the way, a triangle
/// leaves the feasible set, or handles inside lock.
Steps<Progress> construct(Workspace& work, const MeshPair& start,
                          const std::vector<PrescribedRegion>& regions);

}  // namespace foldless
