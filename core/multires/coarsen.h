// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// A mesh over the same domain with fewer vertices.
struct CoarseMesh {
  MeshPair mesh;
  std::vector<int> vertices;  ///< index in the fine mesh of each vertex, ascending
};

/// Takes vertices out of a mesh by half-edge collapses until about `goal` are left or no more may
/// go. The boundary, the vertices of `kept` and those that no triangle uses stay, so that the rest
/// domain is the same; rest triangles stay round and grow with the distance from what is kept. The
/// vertices that are left have the positions they had: M is valid, whether M′ is is the caller's to
/// check. Once the token is set it goes no further.
CoarseMesh coarsened(const MeshPair& mesh, const std::vector<int>& kept, int goal,
                     const std::stop_token& token = {});

}  // namespace foldless
