// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy/objective.h"
#include "core/mesh/patches.h"

namespace foldless {

/// E of a patch by itself: all its vertices that are not free are held, with `at`, by vertices of
/// the mesh, as their targets; soft handles at those that are pull as they do in the whole.
Energy energy_of(const Patch& patch, const Points& at, const std::vector<bool>& is_free,
                 const Energy& whole);

}  // namespace foldless
