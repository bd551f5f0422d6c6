// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/energy/element.h"

namespace foldless {

/// Triangles with begin ≤ t < end.
struct TriangleRun {
  int begin, end;
};

/// Vertices with begin ≤ v < end, and all triangles that have one of them as a corner.
struct VertexRange {
  int begin, end;
  std::vector<TriangleRun> runs;  ///< ascending, one at least between two of them

  bool owns(int v) const { return begin <= v && v < end; }
};

/// Ranges that make up all vertices, so many at least, of which few have a triangle in common and
/// whose triangles are in long runs; none where the numbers of vertices and triangles have too
/// little to do with where they are.
std::vector<VertexRange> compact_ranges(const Triangles& triangles, std::size_t vertices,
                                        int count);

}  // namespace foldless
