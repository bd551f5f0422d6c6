// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless {

/// A corner of an outline.
struct OutlineCorner {
  Vec2 rest;
  int vertex = -1;  ///< of the mesh that is there already; −1: none
};

/// The part of a mesh within closed polygons, their left: the sides of these become edges at rest,
/// by splits that leave the map what it is. The first vertices are the corners, polygon by polygon,
/// the next those of `mesh` that are left, in their order, the last ones those where sides cross
/// edges. Precondition: the polygons lie inside of the mesh, which covers its rest domain once.
/// Nothing where they cross or touch themselves or each other, or bound no part on their left.
std::optional<MeshPair> engraved(const MeshPair& mesh,
                                 const std::vector<std::vector<OutlineCorner>>& loops);

}  // namespace foldless
