// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"
#include "core/solve/descent.h"

namespace foldless {

/// How the handles are led to their targets.
enum class Course {
  straight,  ///< by the targets themselves
  in_legs    ///< by the stops of legs_of(), which need not be reached: they break the symmetry
};

/// The stage for handles that could not be carried home: minimises E under a penalty α that grows
/// from weak to the paper's, so that the whole mesh follows the handles before they press on the
/// triangles next to them. Arrives when the handles can be put exactly on their targets.
Steps<Progress> approach(Workspace& work, FactorUse use, Course course = Course::straight);

}  // namespace foldless
