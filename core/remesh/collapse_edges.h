// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/element.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Which vertices may go.
struct CollapseSettings {
  EnergySettings energy;
  int first_removable = 0;  ///< vertices of lower index stay and keep their indices
  double largest_rise = 0;  ///< by which a vertex may raise the distortion and barrier
  /// σ₁/σ₂ that the triangles round a vertex may have when it is gone, or as before if that was
  /// more.
  double largest_distortion = 100;
};

/// Removes vertices by half-edge collapses, those that raise the energy least first: the triangles
/// round a vertex give way to those of one of its neighbours with the edges of its link. Both
/// meshes stay locally injective, at the boundary too, every new triangle has the least shape that
/// flips ask for, the topology stays, and so do outline and area of the rest mesh: a vertex of the
/// boundary goes only where the rest boundary is straight. The vertices that are left move up, so
/// that indices stay dense; every index of a vertex from `first_removable` on is void when any were
/// removed. Returns how many.
int collapse_edges(MeshPair& mesh, const CollapseSettings& settings);

}  // namespace foldless
