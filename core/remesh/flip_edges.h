// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/element.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// When an edge is flipped (4.3).
struct FlipSettings {
  EnergySettings energy;
  double eta = 1e-3;           ///< least relative decrease of the energy of the diamond
  bool condition_test = true;  ///< cancel a flip that raises cond, eq. 10
  /// Nothing is flipped where all gains together are less than this part of the energy.
  double least_total_gain = 0;
};

/// FlipEdges (4.3): flips edges in descending order of Δ_ab = E_ab − Ē_ab, distortion and barrier
/// of the diamond, as long as Δ_ab > η E_ab. Constraints do not change; E never rises; both meshes
/// stay locally injective. Returns the number of flips.
int flip_edges(MeshPair& mesh, const FlipSettings& settings);

}  // namespace foldless
