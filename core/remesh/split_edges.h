// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/remesh/blockage.h"

namespace foldless {

/// A vertex and where it wants to go.
struct MovingDirection {
  int vertex;
  Vec2 direction;  ///< F_v of eq. 12, any length but zero
};

/// Bounds on what a call of split_edges() may do.
struct SplitSettings {
  double shortest_edge = 1e-5;               ///< no half becomes shorter, in either mesh [length]
  double delta = 1e-5;                       ///< bound of eq. 4, which rounding must not break
  int most_splits = 64;                      ///< a call
  std::span<const int> fixed_boundary = {};  ///< sorted vertices whose boundary edges stay
};

/// True when the edge may be split there: no half becomes too short in either mesh, and rounding
/// takes none of the new triangles out of the feasible set.
bool is_split_safe(const MeshPair& mesh, const EdgeSplit& split, const SplitSettings& settings);

/// True when it is safe, and no boundary edge between fixed vertices.
bool may_split(const MeshPair& mesh, const EdgeSplit& split, const SplitSettings& settings);

/// SplitEdges (4.4): splits, vertex by vertex, the edges that block the way of each. The map does
/// not change and both meshes stay locally injective; new vertices are free. Returns the number of
/// splits.
int split_edges(MeshPair& mesh, const std::vector<MovingDirection>& directions,
                const SplitSettings& settings);

/// Splits every edge that may be split in its middle, which makes about four triangles of one.
/// Returns the number of splits; `settings.most_splits` does not count.
int split_all_edges(MeshPair& mesh, const SplitSettings& settings);

}  // namespace foldless
