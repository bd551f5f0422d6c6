// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/energy/constraints.h"
#include "core/linear/cholesky.h"
#include "core/linear/sparse_symmetric.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// What lies between two maps of one mesh [ACOL00]: the change of a triangle from one to the other
/// is parted into a rotation and a stretch, which both go on at an even pace, neighbours turning
/// the same way round; the vertices follow as their triangles want them to go, in the least squares
/// weighted by rest areas. Nothing says that what lies between is valid: that is the caller's to
/// check.
class MapInterpolation {
 public:
  /// From the deformed positions of the mesh to `to` (2 × #V), both positive. Hard handles are at
  /// the same places in both. `mesh` outlives it.
  MapInterpolation(const MeshPair& mesh, const Constraints& constraints, Points to);

  /// False where rounding makes the least squares unsolvable.
  bool is_solvable() const { return cholesky_.has_factor(); }
  /// Positions at t in [0, 1], 2 × #V; at 1 those of `to`, bit for bit. Precondition:
  /// is_solvable().
  Points at(double t);

 private:
  /// What the maps do to a triangle, J₁ = rotation(angle) · stretch · J₀.
  struct Change {
    Mat2 from;         ///< J₀
    double angle = 0;  ///< counter-clockwise, any number of turns [rad]
    Mat2 stretch;      ///< symmetric, positive definite
  };
  /// A triangle of the least squares.
  struct Element {
    std::array<int, 3> nodes;  ///< −1: held
    Eigen::Matrix<double, 2, 3> hats;
    double area;
  };

  void part_changes();
  void turn_with_neighbours();
  void number_free_vertices(const Constraints& constraints);
  void gather_elements();
  void factorize();
  Mat2 gradient_at(const Change& change, double t) const;

  const MeshPair& mesh_;
  Points to_;
  std::vector<Change> changes_;
  std::vector<int> node_of_;  ///< by vertex; −1: held
  int nodes_ = 0;
  std::vector<Element> elements_;
  Cholesky cholesky_;
};

}  // namespace foldless
