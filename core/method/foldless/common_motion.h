// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// Which motions of the handles of a component its other vertices take part in.
enum class CommonMotion {
  exact,  ///< a translation, or a similarity of scale ½ to 2: the handles are on their targets then
  near    ///< a rigid motion that leaves less than half of the way, where that is long
};

/// The stage that takes out what all handles of a part do together: moves every vertex of its
/// component along, at no factorization. The mesh stays as it is where the moved one is not proved
/// valid. Whether a part moved.
Steps<bool> move_together(Workspace& work, CommonMotion which);

}  // namespace foldless
