// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/boundary.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// A boundary vertex v with its neighbours n and p, and its gap γ: the angle outside of the mesh,
/// from p counter-clockwise to n. The triangles at v overlap themselves where it has closed.
struct BoundaryGap {
  int vertex;
  BoundaryNeighbours neighbours;
  double width = 0;  ///< γ̂, below which the barrier begins: that at rest, or a right angle if less
  double area = 0;  ///< a third of the rest area round v [length²]
};

/// The barrier of one gap, A b(γ/γ̂) with b(x) = −(1 − x)² ln x for x < 1 and 0 above, with its
/// derivatives by n and p; those by v are minus their sum. b is twice continuously differentiable
/// and convex; at rest it is 0.
struct GapBarrier {
  double value = 0;  ///< infinite where the gap is closed
  Vec2 by_next = Vec2::Zero(), by_previous = Vec2::Zero();
  /// Positive semidefinite matrices for the moves of n and of p against v, whose sum is not less
  /// than the Hessian: n and p are no neighbours, so that an entry for both would be in no pattern.
  Mat2 next_curvature = Mat2::Zero(), previous_curvature = Mat2::Zero();
};
/// The vectors from v to its neighbours.
struct GapSides {
  Vec2 next, previous;
};
GapSides sides_of(const BoundaryGap& gap, const Points& points);
/// γ where it is less than a right angle, else a right angle.
double angle_between(const GapSides& sides);

/// Nothing but the value where the gap is closed.
GapBarrier gap_barrier(const BoundaryGap& gap, const Points& u);
double gap_barrier_value(const BoundaryGap& gap, const Points& u);

}  // namespace foldless
