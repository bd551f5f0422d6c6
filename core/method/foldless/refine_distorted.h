// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for a settled mesh none of whose triangles is crushed but some are distorted, often
/// more than the map asks for, as a triangle can only follow it where it is nearly linear: edges of
/// the distorted ones are split and the mesh settles, in rounds, as long as one lowers E Kᵉ by a
/// twentieth. The mesh changes with such rounds alone. Up to kLargestWithCandidates triangles.
Steps<> refine_distorted(Workspace& work);

}  // namespace foldless
