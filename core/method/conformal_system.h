// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/cone/cone_program.h"
#include "core/energy/constraints.h"
#include "core/iteration.h"
#include "core/mesh/injective.h"
#include "core/method/conformal_parts.h"
#include "core/method/method.h"

namespace foldless {

/// What one triangle of rest area A adds to a program in f_z and f_z̄: the cost
/// A (z_weight |f_z − z_target|² + zbar_weight |f_z̄ − zbar_target|²) and the constraint
/// R (Re f_z, Im f_z, Re f_z̄, Im f_z̄) ∈ Q.
struct TriangleTerm {
  double z_weight = 0;
  double zbar_weight = 0;
  Complex z_target = 0;
  Complex zbar_target = 0;
  Eigen::Matrix<double, 3, 4> R = Eigen::Matrix<double, 3, 4>::Zero();
};

/// The term of the t-th triangle of a system; called by several threads at once.
using TermOfTriangle = std::function<TriangleTerm(std::size_t t)>;

/// An energy that is quadratic in f_z and f_z̄ for a given direction of f_z.
struct QuadraticEnergy;

/// What a program is made of.
struct ProgramParts {
  const Points& u;        ///< held vertices stay where it has them
  const Points& targets;  ///< of the soft handles
  TermOfTriangle term_of;
};

/// What [Lip12] and [AL13] have in common: cone programs over the vertices of a mesh that have no
/// hard handle. Hard handles are eliminated, soft ones are
/// springs of stiffness α w. Triangles without such a vertex are not in the programs.
class ConformalSystem {
 public:
  /// Throws Error when the energy is not quadratic in f_z and f_z̄ for a given direction of f_z,
  /// or leaves a component free to grow: `method` is the name for the message.
  ConformalSystem(const Problem& problem, std::string_view method);

  /// Triangles with an unknown vertex: the entries of every list of terms or parts.
  int triangle_count() const { return static_cast<int>(free_.size()); }
  /// f_z and f_z̄ on these triangles.
  std::vector<ConformalParts> parts(const Points& u) const;
  /// The cost of the energy on a triangle; `frame` is the unit direction of f_z, which arap is
  /// frozen at.
  TriangleTerm energy_term(const Complex& frame) const;
  /// u with the hard handles at the targets.
  Points with_handles(Points u, const Points& targets) const;
  /// Makes a program. It is in units of D, so that its tolerances are the same whatever the unit of
  /// length. Memory of `program` is used again; false where the token stopped it, and it is not
  /// whole.
  bool make_program(const ProgramParts& parts, const std::stop_token& token,
                    ConeProgram& program) const;
  /// Makes that program and solves it, see ConeSolver::solve().
  ConeSolution solve(const ProgramParts& parts, double tolerance, const std::stop_token& token);
  /// u with the unknowns replaced by those of a program.
  Points moved(Points u, const Eigen::VectorXd& x) const;
  /// The minimiser of the energy with the handles at the targets; it may fold. Nothing when
  /// cancelled.
  std::optional<Points> unconstrained_minimum(const Points& u, const Points& targets,
                                              const std::stop_token& token);
  /// True when every triangle that the hard handles hold entirely has det J > 0 and σ₁/σ₂ ≤ K.
  bool are_held_triangles_bounded(const Points& u, double K) const;
  /// True when every triangle has det J > 0 and σ₁/σ₂ ≤ K, of those with an unknown vertex.
  bool is_bounded(const Points& u, double K) const;
  /// The distortion energy of a map, folded or not.
  double energy(const Points& u) const;

  ConeSolver solver;

 private:
  struct FreeTriangle {
    Eigen::Vector3i vertices;
    std::array<int, 3> nodes;
    double area;
    Eigen::Matrix<double, 4, 6> B;  ///< (Re f_z, Im f_z, Re f_z̄, Im f_z̄) = B (corners)
  };
  /// A soft handle: where it acts, and how stiff it is.
  struct Spring {
    std::size_t triangle;
    int corner;
    int handle;
    double stiffness;
  };

  void find_unknowns(const Problem& problem);
  void add_springs(const Problem& problem);
  std::vector<std::array<int, 3>> element_nodes() const;
  ConeElement element(const Points& u, const FreeTriangle& triangle,
                      const TriangleTerm& term) const;

  const Density* density_;
  const QuadraticEnergy* quadratic_;  ///< the same
  Points rest_;
  double diagonal_;  ///< D of the rest mesh
  std::vector<int> vertex_of_node_;
  std::vector<int> hard_vertices_;  ///< −1 for the soft among the handles
  std::vector<FreeTriangle> free_;
  std::vector<Eigen::Vector3i> held_;
  std::vector<Spring> springs_;
  ConeProgram program_;  ///< the last that was solved; its memory is used again
};

/// The record of a move from one map to another.
Iteration record_of(const ConformalSystem& system, const MeshPair& mesh, const Points& previous,
                    const Constraints& constraints);

}  // namespace foldless
