// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/method/foldless/prescribed_regions.h"
#include "core/method/foldless/workspace.h"
#include "core/method/stepped_method.h"
#include "core/method/steps.h"

namespace foldless {

/// Whether the way on which the handles came says which map it is to be: where a boundary is held
/// as a whole, handles inside of it, or other boundaries, may have gone round each other. Else any
/// two maps that have the handles at the same places go over into each other without a fold.
bool does_way_matter(const std::vector<PrescribedRegion>& regions);

/// Starts the whole method on another problem.
using Solver = std::function<std::unique_ptr<SteppedMethod>(const Problem& problem)>;

/// The last stage of a drag: its targets are solved once more from rest, in all the ways that are
/// cheap, and that shape is gone over to unless its E Kᵉ is higher by more than 15 %. So what a
/// hand leaves behind follows from where it is, not from the way on which it came there. `work`
/// is what the drag ended with, `original` the triangles of the mesh at rest; see
/// original_triangles(). Nothing happens on very large meshes.
Steps<> start_anew(Workspace& work, const Problem& problem, const Triangles& original,
                   const Solver& solver);

}  // namespace foldless
