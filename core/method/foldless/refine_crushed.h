// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for a settled mesh some of whose triangles are still crushed, most often between
/// handles that leave them no vertex to move: edges of the worst are split and the mesh settles, in
/// rounds, until none is crushed or no round helps. The least distorted mesh of all rounds stays.
/// Up to kLargestWithCandidates triangles.
Steps<> refine_crushed(Workspace& work);

}  // namespace foldless
