// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editor/canvas.h"
#include "core/snapshot.h"

namespace foldless {

/// What one points at on a mesh, the same in both of its poses.
struct MeshPlace {
  int triangle = 0;          ///< the one under the pointer
  std::vector<int> corners;  ///< one: a vertex; two: an edge, the smaller first; three: a triangle

  bool operator==(const MeshPlace&) const = default;
};

/// What is under a pixel: a vertex or an edge close by, or else the triangle; nothing outside the
/// mesh. `points` (2 × #V) are the positions that the canvas shows.
std::optional<MeshPlace> place_at(const Triangles& triangles, const Points& points,
                                  const Canvas& canvas, const Vec2& pixel);

/// "Vertex 213, made by a split", "Edge 12–45, flipped", "Triangle 7: A′/A 0.31, σ₁/σ₂ 2.1".
std::string words_of(const MeshPlace& place, const Snapshot& snapshot);

}  // namespace foldless
