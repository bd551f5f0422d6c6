// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// How many steps a walk takes.
inline constexpr int kStepsOfAWalk = 12;

/// Positions on a way from those of a mesh to others (2 × #V, the last are `to`), as in
/// MapInterpolation, with neither a triangle that leaves the feasible set nor a gap that closes on
/// the lines from one to the next. Empty where that way leaves it. Preconditions: both are feasible
/// and have hard handles at the same places.
std::vector<Points> way_over(const Workspace& work, const Points& to);

/// Goes over to another map of the same rest mesh, in steps that can be watched: along way_over()
/// where one of the two triangulations bears both maps and that way, else led along it by springs,
/// as far as it goes without a fold. At once where no vertex moves far or one mesh has more of
/// them. Precondition: vertices that may not be removed and handles are those of `work`.
Steps<> walk_over(Workspace& work, MeshPair to);

}  // namespace foldless
