// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/injective.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// Where and when a moving mesh stops to be locally injective.
struct MotionFailure {
  enum class Place { triangle, boundary_vertex, branch_vertex };
  Place place = Place::triangle;
  int index = 0;      ///< of the triangle or the vertex
  double moment = 0;  ///< the first, in [0, 1] from the first to the second frame; rounded

  bool operator==(const MotionFailure&) const = default;
};

/// Proof that a mesh whose vertices go straight from one frame to the next, as viewers move them,
/// is locally injective at every moment, exact and without tolerance. Triangles: their area never
/// reaches 0. Boundary vertices: as long as their triangles are counter-clockwise, the angles add
/// up to 2π first where the two boundary edges come to lie on each other. Interior vertices: how
/// often their triangles wind round them cannot change before one has no area, so once at the start
/// is once for ever. O(#V + #F) a step.
class MotionProof {
 public:
  /// Precondition: oriented manifold triangles, indices in [0, vertex_count).
  MotionProof(const Triangles& triangles, int vertex_count);

  /// The first failure on the way between two frames, 2 × #V each; nothing when there is none.
  std::optional<MotionFailure> first_failure(const Points& from, const Points& to) const;

 private:
  std::optional<MotionFailure> failure_at_start(const Points& from) const;

  Triangles triangles_;
  InjectivityChecker checker_;
  std::vector<BoundaryNeighbours> boundary_;  ///< by vertex
};

}  // namespace foldless
