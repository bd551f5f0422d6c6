// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// An edge to split, and where.
struct EdgeSplit {
  int edge;   ///< edge index
  double at;  ///< parameter in (0, 1) from edge(e)[0] to edge(e)[1], the same in both meshes
};

/// What stops a vertex v of M′ on its way along a direction while everything else stands still
/// (4.4).
struct Blockage {
  Vec2 v_alpha;               ///< v_α of eq. 13: where the first triangles round v fold
  std::vector<int> blocking;  ///< C_α(v): the link edges whose lines contain v_α, edge indices
  std::vector<EdgeSplit> splits;  ///< what the appendix splits to let v through, in order
};

/// The blockage of vertex v along `direction` (any length but zero). Nothing when no triangle
/// round v would ever fold, or when v has no triangle.
///
/// Each connected component of C_α is handled by itself, the farthest from v_α first. For an edge
/// of it: (1) v_α inside the edge: split the edge; (2) v_α outside: split the spoke from v to the
/// end farther from v_α, which would sweep across the nearer end; (3) v_α at an end: both, which
/// makes the four edges of the paper where two edges of C_α meet in v_α.
std::optional<Blockage> blockage_of(const MeshPair& mesh, int v, const Vec2& direction);

}  // namespace foldless
