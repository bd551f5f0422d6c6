// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for a settled mesh some of whose triangles are still crushed, most often between
/// handles that leave them no vertex to move: edges of the worst are split and the mesh settles, in
/// rounds, until none is crushed or no round helps. What is crushed then is tidied and refined
/// again, in passes, in the end with distortion lowered to where it is enough at up to ten times
/// the energy. The mesh stays as it is but for less distorted ones, which take its place. Up to
/// kLargestWithCandidates triangles.
Steps<> refine_crushed(Workspace& work);

}  // namespace foldless
