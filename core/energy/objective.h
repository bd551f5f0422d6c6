// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/energy/boundary_guard.h"
#include "core/energy/constraints.h"
#include "core/energy/element.h"
#include "core/energy/element_loops.h"
#include "core/energy/shared_elements.h"
#include "core/energy/vertex_ranges.h"
#include "core/linear/sparse_symmetric.h"
#include "core/mesh/mesh_pair.h"
#include "core/threads/unfilled_vector.h"

namespace foldless {

/// What is minimised on a mesh, eq. 5: distortion and barrier as the settings say, and the penalty
/// of the constraints. A stage owns one and hands it to every step.
struct Energy {
  EnergySettings settings;
  Constraints constraints;
};

/// The three terms of eq. 5, weights included.
struct EnergyTerms {
  double distortion = 0;  ///< E_d
  double penalty = 0;     ///< α E_c
  double barrier = 0;     ///< β E_b and that of the gaps, infinite outside the feasible set
  double total() const { return distortion + penalty + barrier; }
  void add(const ElementEnergy& elements) {
    distortion += elements.distortion;
    barrier += elements.barrier;
  }
};

/// E with ∇E.
struct EnergyGradient {
  EnergyTerms energy;
  Eigen::VectorXd gradient;  ///< 2 #V
};

/// E(u) of eq. 5 on one connectivity: value, gradient and Hessian of whichever energy it is given.
/// Positions u and steps are 2 × #V; a gradient has the pair (x, y) of every vertex. Make it anew
/// after splits.
class Objective {
 public:
  /// `constraints` tells which vertices have a hard handle; every energy has the same.
  Objective(const MeshPair& mesh, const Constraints& constraints);

  /// Follows the triangles of the same mesh after flips; what did not change is kept.
  void follow_flips(const MeshPair& mesh);

  /// Infinite terms when u is outside the feasible set.
  EnergyTerms value(const Energy& energy, const Points& u) const;
  /// E and ∇E. Precondition: u is feasible.
  EnergyGradient gradient(const Energy& energy, const Points& u) const;
  /// E and ∇E, and ∇²E into `hessian`, which has the pattern of hessian_pattern(); its elements are
  /// without the part `clamping` of their negative curvature. Rows and columns of held handles are
  /// those of the identity. Precondition: u is feasible.
  EnergyGradient assemble(const Energy& energy, const Points& u, SparseSymmetric& hessian,
                          double clamping = 0) const;
  /// How ∇E changes at the other vertices, to first order, when hard handles move by `way` (2 × #V,
  /// zero elsewhere): K_fh way of ∇²E with clamped elements, 2 #V, zero at those handles.
  /// Precondition: u is feasible.
  Eigen::VectorXd pull_of_handles(const EnergySettings& settings, const Points& u,
                                  const Points& way) const;
  /// ∇²E with all values zero.
  SparseSymmetric hessian_pattern() const;

  /// The largest t for which A′ > δA holds in every triangle on all of u + τ s, 0 ≤ τ < t, and
  /// where the settings guard the boundary no gap closes; infinite when nothing bounds it, 0 when a
  /// triangle is not so at u.
  double largest_step(const EnergySettings& settings, const Points& u, const Points& step) const;
  /// The part of gaps in that.
  double largest_step_of_gaps(const EnergySettings& settings, const Points& u,
                              const Points& step) const;
  /// The triangles that bound that t below `bound`, in ascending order.
  std::vector<int> triangles_in_way(const EnergySettings& settings, const Points& u,
                                    const Points& step, double bound) const;
  /// Whether A′ > δA holds in every triangle at the end of a step from u, and no guarded gap has
  /// closed: rounding can take a bounded step that ends near a fold beyond it.
  bool is_feasible(const EnergySettings& settings, const Points& u, const Points& end) const;
  /// The second part of that, which value() tells to rounding alone.
  bool are_gaps_open(const EnergySettings& settings, const Points& u, const Points& end) const;

 private:
  bool has_hard_handle(int v) const { return has_hard_handle_[static_cast<std::size_t>(v)]; }
  /// −1 for a vertex that is no unknown.
  int node_of(int v, const Constraints& constraints) const {
    return constraints.held && has_hard_handle(v) ? -1 : v;
  }
  /// True where the triangles are enough to share, and there is a team.
  bool is_shared() const {
    return present_team() && !(vertex_ranges_.empty() && corners_.is_empty());
  }
  /// Likewise, where they make up compact ranges.
  bool is_in_ranges() const { return present_team() && !vertex_ranges_.empty(); }
  RestElement reference(const EnergySettings& settings, Eigen::Index t) const {
    return reference_element(settings, rest_[static_cast<std::size_t>(t)]);
  }
  /// u + t step for 0 ≤ t ≤ bound.
  struct Segment {
    const Points& u;
    const Points& step;
    double bound;
  };
  /// The largest step of one triangle; one beyond the segment may come as infinite.
  double largest_step_of(Eigen::Index t, const EnergySettings& settings,
                         const Segment& segment) const;
  ElementBatch batch_of(const Energy& energy, const Points& u, double clamping = 0) const {
    return {energy.settings, triangles_, rest_, u, clamping};
  }
  void sum_elements(const ElementBatch& batch, EnergyTerms& sum) const;
  void sum_elements(const ElementBatch& batch, EnergyGradient& sum) const;
  void sum_elements(const ElementBatch& batch, const Constraints& constraints, EnergyGradient& sum,
                    SparseSymmetric& hessian) const;
  /// A corner of a triangle.
  struct Corner {
    std::ptrdiff_t triangle;
    int corner;
  };
  /// To the columns of the corner's vertex, unless it is no unknown, what a triangle gives there.
  void add_columns(const BlocksOf<double>& blocks, const Corner& of, const Constraints& constraints,
                   SparseSymmetric& hessian) const;
  // The same bits, by all threads of the team (shared_objective.cpp).
  void sum_shared(const ElementBatch& batch, EnergyTerms& sum) const;
  void sum_shared(const ElementBatch& batch, EnergyGradient& sum) const;
  void sum_shared(const ElementBatch& batch, const Constraints& constraints, EnergyGradient& sum,
                  SparseSymmetric& hessian) const;
  SparseSymmetric shared_pattern() const;
  // Likewise, by ranges (ranged_objective.cpp).
  void sum_ranges(const ElementBatch& batch, EnergyGradient& sum) const;
  void sum_ranges(const ElementBatch& batch, const Constraints& constraints, EnergyGradient& sum,
                  SparseSymmetric& hessian) const;
  SparseSymmetric ranged_pattern() const;
  /// Adds up what all triangles have, by threads. Of every few the first has their sum then.
  void add_energies(ElementEnergy* energies, EnergyTerms& sum) const;
  void add_gaps(const EnergySettings& settings, const Points& u, EnergyGradient& sum) const;
  void add_gaps(const Energy& energy, const Points& u, SparseSymmetric& hessian) const;
  void add_pull_of_gaps(const EnergySettings& settings, const Points& u, const Points& way,
                        Eigen::VectorXd& pull) const;

  std::vector<bool> has_hard_handle_;       ///< by vertex
  Triangles triangles_;                     ///< 3 × #F
  UnfilledVector<RestElement> rest_;        ///< one a triangle
  std::vector<int> triangles_of_handles_;   ///< those with a corner at a hard handle
  std::vector<VertexRange> vertex_ranges_;  ///< none where the triangles are too few to share
  CornersOfVertices corners_;               ///< where they lie too scattered for ranges
  Scratch<ElementEnergy> energies_;
  Scratch<Matrix2<double>> gradients_;
  Scratch<BlocksOf<double>> hessians_;
  BoundaryGuard guard_;
};

}  // namespace foldless
