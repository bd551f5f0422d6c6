// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// `mesh` with the map of a coarser one over a component of it that is a disk. The first vertices
/// of `coarse` are the vertices `corners` of `mesh`, those along its boundary among them. The rest
/// positions of all vertices stay; those inside are connected anew: a Delaunay triangulation of
/// those within each triangle of `coarse`, whose other vertices become the last ones.
/// Nothing where rounding leaves a mesh that is not proved locally injective.
std::optional<MeshPair> filled(const MeshPair& coarse, const std::vector<int>& corners,
                               const MeshPair& mesh);

}  // namespace foldless
