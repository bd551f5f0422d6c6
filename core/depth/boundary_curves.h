// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// The boundary of a mesh, by which one can tell without a look at its triangles whether a locally
/// injective map of it covers some point twice. It does not exactly when the curves of the boundary
/// meet nowhere, turn as often as they must, and no component lies inside another: the number of
/// times that a component covers a point is the sum of the winding numbers of its curves, of which
/// only one can then be positive, as their turning numbers add up to the Euler characteristic.
class BoundaryCurves {
 public:
  /// Precondition: oriented manifold triangles with indices in [0, vertex_count).
  BoundaryCurves(const Triangles& triangles, int vertex_count);

  /// Whether the angles at every boundary vertex add up to less than 2π. Precondition here and
  /// below: the triangles are counter-clockwise in `points` and cover each interior vertex once.
  bool have_open_corners(const Points& points) const;
  /// Whether two edges meet that are no neighbours. Where rounding leaves that open they do.
  bool meet(const Points& points) const;
  /// Whether a component lies inside another. Precondition: !meet(points).
  bool are_nested(const Points& points) const;

 private:
  struct Curve {
    int first = 0, end = 0;  ///< of the edges of a component
  };

  std::vector<int> from_, to_;  ///< vertices of the edges, a component after the other
  std::vector<BoundaryNeighbours> neighbours_;
  std::vector<Curve> components_;
  std::int64_t euler_characteristic_ = 0;
};

}  // namespace foldless
