// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/method/foldless/workspace.h"
#include "core/method/method.h"
#include "core/method/steps.h"

namespace foldless {

/// The triangles of the mesh that a problem's was remeshed from, over its first `vertices`
/// vertices: those that the original lacks are in it where they are at rest. Nothing where it is
/// not known or rounding leaves no proved rest mesh. Precondition: 0 < vertices ≤ #V.
std::optional<Triangles> original_triangles(const Problem& problem, int vertices);

/// The stage after a drag: the vertices that are in the original triangulation settle in it, flips
/// that their map needs made anew, and that mesh stays where its E Kᵉ is no higher by more than a
/// hundredth. So what a hand flipped and split on its way does not shift the poses that follow, and
/// a handle that is dragged away and back gives the mesh back. `original`: see above.
Steps<> go_back(Workspace& work, const Triangles& original);

}  // namespace foldless
