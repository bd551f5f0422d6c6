// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/method/foldless/transport_plans.h"
#include "core/method/foldless/workspace.h"
#include "core/method/steps.h"

namespace foldless {

/// The stage for handles that the approach could not bring home. It forgets the distortion of the
/// map for a while: from the rest state, handles are carried along paths in short strides under the
/// symmetric Dirichlet energy of each deformed triangle against an equilateral one, flips serving
/// that energy. Where a handle stays behind, edges ahead of it are split. Arrives when the handles
/// are exactly on their targets.
Steps<Progress> transport(Workspace& work, TransportPlan plan);

/// A transport that, where it locks, settles under the energy of the scene with the handles held
/// where they are, which gives triangles that it left as slivers their shape back, and carries the
/// handles on from there; again, while every such round brings them a good deal nearer.
Steps<Progress> transport_in_rounds(Workspace& work, TransportPlan plan);

/// The same from where another transport locked: settles first.
Steps<Progress> transport_onwards(Workspace& work);

}  // namespace foldless
