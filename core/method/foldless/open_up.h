// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The symmetric Dirichlet energy against the rest shapes with the handles held.
Energy opening_energy(const Workspace& work);
/// Lowers it, with flips, until it gains little.
Steps<> lower(Workspace& work, const Energy& energy, int most_steps);

/// Opens a map up that was just constructed, whose triangles may be as narrow as proofs allow, with
/// the handles held: lowers the symmetric Dirichlet energy until it gains little, and once more
/// with every edge split where a triangle of a small mesh is still crushed.
Steps<> open_up(Workspace& work);

}  // namespace foldless
