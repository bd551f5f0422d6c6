// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The approach from `start` with every edge split, for a mesh of at most 2,000 triangles that was
/// deformed before: it goes on in the class of maps that it is in, and the other ways, which begin
/// at rest, end in any. A free boundary gains from it too. `work` becomes its mesh where it
/// arrives.
Steps<Progress> approach_refined(Workspace& work, MeshPair start);

}  // namespace foldless
