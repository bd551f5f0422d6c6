// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for a settled mesh none of whose triangles is crushed but some are distorted, often
/// more than the map asks for, as a triangle can only follow it where it is nearly linear: edges of
/// the distorted ones are split, the most distorted first, and the mesh settles, in rounds, as long
/// as one lowers E Kᵉ by a tenth, to 1.5 times the vertices. The mesh changes with these rounds and
/// a last one that lowers it by a twentieth. Up to 4,000 triangles.
Steps<> refine_distorted(Workspace& work);

}  // namespace foldless
