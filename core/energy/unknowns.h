// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// Which vertices the solver moves: those of the components that have a handle. Vertices that no
/// triangle uses, and components without a handle, stay where they are.
struct Unknowns {
  std::vector<int> node_of_vertex;  ///< −1 for a vertex that stays
  std::vector<int> vertex_of_node;

  int count() const { return static_cast<int>(vertex_of_node.size()); }
};

/// For every vertex of a mesh a number that is the same for two vertices exactly when triangles
/// connect them.
std::vector<int> components_of(const MeshPair& mesh);

/// Unknowns of a mesh whose handles sit at `handle_vertices`.
Unknowns unknowns_of(const MeshPair& mesh, const std::vector<int>& handle_vertices);

}  // namespace foldless
