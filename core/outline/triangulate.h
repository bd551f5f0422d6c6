// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/mesh/shape.h"

namespace foldless {

/// A closed polygon as its corners, without repeating the first; either orientation.
using Loop = std::vector<Vec2>;

/// A region of the plane: inside of `boundary`, outside of every hole.
struct Outline {
  Loop boundary;
  std::vector<Loop> holes;
};

/// What the triangles must be like.
struct TriangulateOptions {
  double edge_length = 0;   ///< no edge is longer; length; 0: as the angles need
  double min_angle = 20.7;  ///< degrees, 0 … 33; corners of the outline itself may be sharper
  int vertex_limit = 1'000'000;  ///< more are refused
  std::stop_token stop = {};     ///< once requested, what comes is only good for throwing away
};

/// Meshes an outline by Delaunay refinement [Ruppert 95, Shewchuk 02]. The outline's corners keep
/// their positions and are the first vertices, the boundary's, then each hole's; edges of the
/// outline may be cut. The same input always gives the same mesh.
/// Throws Error when a loop has fewer than 3 corners or no area, a coordinate is not finite, a
/// loop touches or crosses itself or another, a hole is not inside the boundary, or the options
/// are out of range.
Shape triangulate(const Outline& outline, const TriangulateOptions& options);

}  // namespace foldless
