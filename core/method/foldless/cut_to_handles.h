// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/handles_to_cut.h"
#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for handles that have to make room for each other: components of that kind get a map
/// that has their handles on their targets, see cut_open(), and are opened up while vertices that
/// nobody needs go. Handles elsewhere are then carried and approached as always. Locks where
/// nothing can be constructed, rounding is in the way, a triangle leaves the feasible set, or
/// handles elsewhere lock. `choice`: of the class of maps. Precondition: `work` is at rest.
Steps<Progress> cut_to_handles(Workspace& work, CutBoundary boundary, int choice = 0);

}  // namespace foldless
