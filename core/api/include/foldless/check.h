// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <foldless/error.h>
#include <foldless/mesh.h>

#include <vector>

namespace foldless {

/// What keeps a planar mesh from being locally injective, counted with exact predicates; all zero
/// or empty when it is.
struct Folds {
  int inverted = 0;         ///< triangles that are clockwise
  int degenerate = 0;       ///< triangles of area zero, or with a coordinate that is not finite
  int branch_vertices = 0;  ///< interior vertices that positive triangles go round twice or more
  /// Boundary vertices of positive triangles whose angles add up to 2π or more, ascending.
  std::vector<int> overlapping_boundary_vertices;

  bool is_injective() const {
    return inverted == 0 && degenerate == 0 && branch_vertices == 0 &&
           overlapping_boundary_vertices.empty();
  }
};

/// A proof, or a refutation, that a map is locally injective, and how much it distorts.
struct CheckedMap {
  Folds rest;      ///< of M
  Folds deformed;  ///< of M′
  /// Smallest A′/A, and largest and mean σ₁/σ₂ of triangles that are not folded; not a number when
  /// a triangle of M is not positive. [dimensionless]
  double min_area_ratio = 0;
  double max_conformal_distortion = 0;
  double mean_conformal_distortion = 0;

  bool is_injective() const { return rest.is_injective() && deformed.is_injective(); }
};

/// Checks a mesh, #V × 2 at rest and #F × 3, and its image, #V × 2. Throws Error when the arrays
/// are not those of an oriented manifold and its image.
CheckedMap check(const PointsRef& rest, const TrianglesRef& triangles, const PointsRef& deformed);

}  // namespace foldless
