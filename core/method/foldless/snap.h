// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"

namespace foldless {

/// Whether the handles are so near to their targets that they may be put there by themselves.
bool is_near(const Workspace& work);

/// Puts the handles exactly on their targets if no triangle leaves the feasible set on the way, nor
/// E_d + E_b of `energy` grows much.
bool snap(Workspace& work, const EnergySettings& energy);

}  // namespace foldless
