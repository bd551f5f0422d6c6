// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/energy/element.h"
#include "core/energy/positions.h"
#include "core/energy/sparse_symmetric.h"
#include "core/energy/unknowns.h"
#include "core/mesh/mesh_pair.h"

namespace foldless {

/// The three terms of eq. 5, weights included.
struct EnergyTerms {
  double distortion = 0;  ///< E_d
  double penalty = 0;     ///< α E_c
  double barrier = 0;     ///< β E_b, infinite outside the feasible set
  double total() const { return distortion + penalty + barrier; }
};

/// E with ∇E.
struct EnergyGradient {
  EnergyTerms energy;
  Eigen::VectorXd gradient;  ///< 2 #unknowns
};

/// E(u) of eq. 5 for one connectivity: value, gradient and Hessian. Positions u are 2 × #V; the
/// gradient has one pair (x, y) per unknown node. Make it anew after splits.
class Objective {
 public:
  Objective(const EnergySettings& settings, const MeshPair& mesh, const Positions& positions);

  /// Takes over the triangles of the same mesh after flips; what did not change is kept.
  void take_flips(const MeshPair& mesh);

  const Unknowns& unknowns() const { return unknowns_; }
  const EnergySettings& settings() const { return settings_; }
  void set_alpha(double alpha) { settings_.alpha = alpha; }
  void set_conformal_weight(double weight) { settings_.conformal_weight = weight; }

  /// Infinite terms when u is outside the feasible set.
  EnergyTerms value(const Points& u, const Positions& positions) const;
  /// E and ∇E. Precondition: u is feasible.
  EnergyGradient gradient(const Points& u, const Positions& positions) const;
  /// E and ∇E, and ∇²E into `hessian`, which has the pattern of hessian_pattern(); its elements are
  /// without the part `clamping` of their negative curvature. Rows and columns of held handles are
  /// those of the identity. Precondition: u is feasible.
  EnergyGradient assemble(const Points& u, const Positions& positions, SparseSymmetric& hessian,
                          double clamping = 0) const;
  /// How ∇E changes at the other unknowns, to first order, when handles that may be held move by
  /// `way` (2 × #V, zero elsewhere): K_fh way of ∇²E with clamped elements, 2 #unknowns, zero at
  /// those handles. Precondition: u is feasible.
  Eigen::VectorXd pull_of_handles(const Points& u, const Points& way) const;
  /// ∇²E with all values zero.
  SparseSymmetric hessian_pattern() const;

  /// The largest t for which A′ > δA holds in every triangle on all of u + τ s, 0 ≤ τ < t; infinite
  /// when nothing bounds it. `step` is 2 × #V.
  double largest_step(const Points& u, const Points& step) const;
  /// A direction over the unknowns as displacements of all vertices, 2 × #V.
  Points spread(const Eigen::VectorXd& direction) const;

 private:
  void add_positions(const Points& u, const Positions& positions, EnergyGradient& sum) const;
  void add_positions(const Positions& positions, SparseSymmetric& hessian) const;
  bool is_handle(int node) const { return is_handle_[static_cast<std::size_t>(node)]; }
  int node_of(int v) const { return unknowns_.node_of_vertex[static_cast<std::size_t>(v)]; }

  EnergySettings settings_;
  Unknowns unknowns_;
  std::vector<bool> is_handle_;                     ///< by node: a handle that may be held
  Triangles triangles_;                             ///< of the components that move
  std::vector<RestElement> rest_;                   ///< one a triangle
  std::vector<Eigen::Index> triangles_of_handles_;  ///< those with a corner at such a handle
};

}  // namespace foldless
