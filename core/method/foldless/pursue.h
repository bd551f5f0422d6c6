// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The first stage, and that of a drag: the handles are carried to their targets by Newton steps
/// that have their way on the right-hand side, in one when it is short. Arrives when the handles
/// are exactly there. Locks when steps in a row gain little, with the handles that much nearer.
Steps<Progress> pursue(Workspace& work);

}  // namespace foldless
