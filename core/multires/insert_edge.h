// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Flips the edges of M that cross the segment from vertex a to vertex b until it is an edge, or a
/// chain of edges where vertices lie on it [Slo93]. Precondition: the segment lies in the domain.
/// M stays as valid as it was; M′ is not looked at and may fold. Returns the number of flips.
int insert_edge(MeshPair& mesh, int a, int b);

}  // namespace foldless
