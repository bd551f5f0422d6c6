// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/energy/element.h"
#include "core/multires/coarsen.h"

namespace foldless {

/// A fine mesh with the map of a coarse one.
struct ProlongedMesh {
  MeshPair mesh;
  int flips = 0;   ///< of edges of the fine mesh
  int splits = 0;  ///< vertices that the fine mesh got
  /// For every vertex the triangle of the coarse mesh that holds it at rest, −1 where no triangle
  /// uses it.
  std::vector<int> holding = {};
};

/// The fine mesh under the map of a coarse one over the same rest domain: every vertex goes where
/// the coarse triangle that holds it at rest takes it. The first vertices of the coarse mesh are
/// `coarse.vertices` of the fine one and go where they are; edges of the coarse mesh may have been
/// flipped and split since it was made. Where a fine triangle lies across coarse edges and comes
/// out folded, or with much more of `energy` than the coarse ones, those edges become edges of the
/// fine mesh by flips, so that the map is the coarse one there. Where the fine mesh folds or leaves
/// the feasible set, A′ > δA, all the same, those of these edges that end at vertices which splits
/// made become edges of it too: it gets these vertices, behind its own. Nothing when it is not
/// locally injective then, or not feasible where the coarse one is, or a stop is requested.
std::optional<ProlongedMesh> prolonged(const CoarseMesh& coarse, const MeshPair& fine,
                                       const EnergySettings& energy,
                                       const std::stop_token& token = {});

}  // namespace foldless
