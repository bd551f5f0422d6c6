// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/snapshot.h"

namespace foldless {

/// What is known of a mesh, decided with exact predicates.
struct Proof {
  int inverted = 0;         ///< triangles whose area is not positive, in either mesh
  int branch_vertices = 0;  ///< interior vertices that their triangles wind round twice or more
  /// Boundary vertices whose angles add up to 2π or more, in either mesh.
  int overlapping_boundary_vertices = 0;
  double min_area_ratio = 1;            ///< smallest signed A′/A
  double max_conformal_distortion = 1;  ///< largest σ₁/σ₂ of the triangles that are not inverted
  int triangles = 0;
  int vertices = 0;

  /// True when the map is locally injective, at the boundary too.
  bool holds() const { return !folds() && overlapping_boundary_vertices == 0; }
  /// True when it is not even inside: such a map is not kept. One that overlaps itself at boundary
  /// vertices alone, as the published methods leave them, may be.
  bool folds() const { return inverted > 0 || branch_vertices > 0; }
};

/// O(#V + #F); of a mesh without triangles nothing but that is known.
Proof proof_of(const Snapshot& pose);

/// What is wrong in words, "This map folds: 3 triangles are inverted", "2 boundary vertices overlap
/// themselves"; empty when nothing is.
std::string fold_words(const Proof& proof);

}  // namespace foldless
