// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/energy/element.h"
#include "core/energy/gap_barrier.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// A boundary edge from v to a neighbour with its part of the Hessian: that of the moves of its
/// ends against each other.
struct GapSide {
  int vertex, neighbour;
  Mat2 curvature;
};

/// Keeps the gaps of a mesh open: the barrier on them, and a bound on steps. Barriers see a gap
/// but for full turns, so they are nothing without the bound. A vertex that overlaps itself, at
/// rest or where the mesh is when the guard is made, is left out of both.
class BoundaryGuard {
 public:
  explicit BoundaryGuard(const MeshPair& mesh);

  /// Takes the areas round vertices from the triangles as they are after flips.
  void follow_flips(const Triangles& triangles, std::span<const RestElement> rest);

  /// Σ A b; infinite where a gap has closed.
  double value(const Points& u) const;
  /// Adds `weight` times its gradient; returns Σ A b.
  double add_gradient(double weight, const Points& u, Eigen::VectorXd& gradient) const;
  /// The sides of gaps along which Σ A b is curved.
  std::vector<GapSide> curved_sides(const Points& u) const;

  /// The largest t for which no gap has closed anywhere on u + τ s, 0 ≤ τ < t; infinite when none
  /// does.
  double largest_step(const Points& u, const Points& step) const;
  /// Whether no gap that was less than a right angle at u is closed, or closed but for 1e-9 rad, at
  /// the end of a bounded step. Gaps that were narrower at u are told exactly.
  bool stays_open(const Points& u, const Points& end) const;

 private:
  std::vector<BoundaryGap> gaps_;
  std::vector<int> gap_of_;  ///< by vertex, −1 without one
};

}  // namespace foldless
