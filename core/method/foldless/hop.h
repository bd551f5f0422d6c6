// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// From the minimum that a mesh has settled in to lower ones near by, as basin hopping [WD97] with
/// a perturbation that is not random: it settles with an ε so large that triangles become round,
/// whatever it costs in E, and flips on the way lead out of the basin; then with that of tidy().
/// What it ends in takes the place of the mesh where its E_d is lower, see has_less_energy(), and
/// its σ₁/σ₂ within most_distortion_beside() the first, or where a crushed mesh becomes far less
/// crushed; else that was the last hop, as is one that lowers E by less than a hundredth. Meshes
/// that are hardly distorted, or have more than kLargestWithCandidates triangles, stay as they are.
Steps<> hop(Workspace& work);

}  // namespace foldless
