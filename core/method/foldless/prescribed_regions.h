// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy/constraints.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// A connected component of a mesh with handles that are not soft on its whole boundary: whatever
/// is flipped and split inside, the boundary of its image is the polygons of their targets.
/// Handles are indices into Constraints.
struct PrescribedRegion {
  std::vector<std::vector<int>> loops;  ///< handles along the boundary, the region on their left
  std::vector<int> inside;              ///< those that are not soft and not on the boundary
  int euler_characteristic = 0;         ///< #V − #E + #F
};

/// All of them. They depend on the connectivity and on which vertices are handles, not on targets.
std::vector<PrescribedRegion> prescribed_regions(const MeshPair& mesh,
                                                 const Constraints& constraints);

/// Those of handles, in their order.
std::vector<int> vertices_of(const std::vector<int>& handles, const Constraints& constraints);

/// The vertices of their boundaries, sorted.
std::vector<int> boundary_vertices(const std::vector<PrescribedRegion>& regions,
                                   const Constraints& constraints);

}  // namespace foldless
