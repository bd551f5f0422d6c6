// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// What keeps a mesh from being locally injective; all zero or empty when it is.
struct InjectivityReport {
  int inverted = 0;         ///< triangles that are clockwise
  int degenerate = 0;       ///< triangles of area exactly zero, or with a coordinate not finite
  int branch_vertices = 0;  ///< interior vertices of positive triangles, wound more than once
  std::optional<int> first_inverted;       ///< triangle index
  std::optional<int> first_degenerate;     ///< triangle index
  std::optional<int> first_branch_vertex;  ///< vertex index
  /// Boundary vertices of positive triangles whose angles add up to 2π or more, ascending.
  std::vector<int> overlapping_boundary_vertices = {};

  bool is_injective() const {
    return is_injective_inside() && overlapping_boundary_vertices.empty();
  }
  /// Locally injective but for boundary vertices: as much as the published methods promise.
  bool is_injective_inside() const {
    return inverted == 0 && degenerate == 0 && branch_vertices == 0;
  }
};

/// True for every vertex whose edges all have two triangles; false at the boundary and for
/// vertices without a triangle. `boundary` are the neighbours of every vertex. O(#V + #F).
std::vector<bool> interior_vertices(const Triangles& triangles,
                                    const std::vector<BoundaryNeighbours>& boundary);

/// Proof that a planar mesh is locally injective, exact and without tolerance: every triangle is
/// counter-clockwise, the triangles round every interior vertex cover it once, and the angles at
/// every boundary vertex add up to less than 2π. Keeps what depends on the connectivity only, for
/// many sets of positions. O(#V + #F) a check.
class InjectivityChecker {
 public:
  /// Precondition: oriented manifold triangles, indices in [0, vertex_count).
  InjectivityChecker(Triangles triangles, int vertex_count);

  /// Everything that is wrong with positions (2 × #V).
  InjectivityReport check(const Points& points) const;
  bool is_injective(const Points& points) const { return check(points).is_injective(); }
  bool is_injective_inside(const Points& points) const {
    return check(points).is_injective_inside();
  }

 private:
  /// Whether nothing is wrong with them, found in one pass over the triangles.
  bool is_proved(const Points& points) const;
  /// What is.
  InjectivityReport report_on(const Points& points) const;

  Triangles triangles_;
  std::vector<BoundaryNeighbours> boundary_;  ///< by vertex
  std::vector<bool> interior_;                ///< likewise
  std::ptrdiff_t interior_count_;             ///< how many vertices are
  std::vector<int> outer_triangles_;          ///< that have a corner at the boundary
};

/// One check of a mesh; see InjectivityChecker.
InjectivityReport check_injectivity(const Triangles& triangles, const Points& points);

/// True when the mesh is locally injective; see InjectivityChecker.
bool is_injective(const Triangles& triangles, const Points& points);

/// True when both meshes of one connectivity are.
bool is_injective(const Triangles& triangles, const Points& rest, const Points& deformed);
/// True when both are but for boundary vertices.
bool is_injective_inside(const Triangles& triangles, const Points& rest, const Points& deformed);

/// The boundary vertices at which a mesh overlaps itself, ascending; see InjectivityReport.
std::vector<int> overlapping_boundary_vertices(const Triangles& triangles, const Points& points);

}  // namespace foldless
