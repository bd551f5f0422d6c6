// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"
#include "core/solve/descent.h"

namespace foldless {

/// The stage for handles that could not be carried home: minimises E under a penalty α that grows
/// from weak to the paper's, so that the whole mesh follows the handles before they press on the
/// triangles next to them. Arrives when the handles can be put exactly on their targets.
/// It goes by the `stops`, the last of which is the targets; they need not be reached. Without any
/// it aims at the targets from the beginning.
Steps<Progress> approach(Workspace& work, FactorUse use, std::vector<Points> stops = {});

}  // namespace foldless
