// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/energy/element.h"
#include "core/linear/cholesky.h"
#include "core/linear/conjugate_gradients.h"
#include "core/linear/interpolation.h"
#include "core/linear/local_solve.h"
#include "core/linear/multigrid.h"

namespace foldless {

/// What a Hessian is of, as far as an earlier factor cannot make up for it.
struct HessianKind {
  const Density* density = nullptr;
  double beta = 0;
  Reference reference = Reference::rest;
  bool held = false;
  bool operator==(const HessianKind&) const = default;
};

/// ∇²E as it was assembled last.
struct Hessian {
  SparseSymmetric matrix;
  HessianKind kind;
};

/// The Hessian of a coarse mesh, as conjugate gradients of a finer one need it.
struct CoarseHessian {
  HessianKind kind;
  std::shared_ptr<CoarseGrid> grid;
};

/// The factor of a Hessian + μI, and what is known of how far it serves later ones; before there is
/// one, the Hessian of a coarse mesh in its place. Copyable.
class HessianFactor {
 public:
  /// Says that the matrix has another pattern from now on.
  void outdate_pattern();
  /// Says that the mesh has other vertices from now on, or its handles are others.
  void forget_mesh();
  /// Orders and analyses the pattern where that is due.
  void analyze(const SparseSymmetric& matrix);
  /// What may stop factorizations and iterations from now on.
  void obey(const std::stop_token& token) { cholesky_.obey(token); }
  /// How exact a factor is to be that iterations begin from: the roughest that is worth while.
  Precision for_iterations(const Hessian& hessian) const;
  /// Says that one of for_iterations() did not do for a Hessian that is positive definite: where
  /// triangles are nearly crushed their stiffness drowns the rest, and goes on to.
  void set_too_rough();
  /// False when the Hessian + μI is not positive definite, or where it was stopped. Precondition:
  /// it is analysed.
  bool factorize(const Hessian& hessian, double mu, Precision precision);
  /// Solves with the factor. Precondition: the last factorization succeeded, in full precision.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) {
    return cholesky_.solve(right_hand_side);
  }

  /// True when it is the factor of ∇²E itself as assembled last, in full precision.
  bool is_exact() const {
    return is_own_ && cholesky_.has_factor() && cholesky_.precision() == Precision::full;
  }
  /// Says that another ∇²E was assembled, or that the vertices moved.
  void outdate() { is_own_ = false; }
  /// Says that ∇²E changed too much for the factor to serve another step.
  void set_far() { is_near_ = false; }
  /// Solves hessian x = b by conjugate gradients from this factor and guesses, or else, without
  /// guesses, from the Hessian of the coarse mesh; nothing where they are of another kind of
  /// Hessian or known to be too far from it, or turn out to be, or where it was stopped.
  std::optional<ConjugateGradientSolution> solve_later(const Hessian& hessian,
                                                       const Eigen::VectorXd& b, double least_gain,
                                                       std::span<const Eigen::VectorXd> guesses);
  /// Takes the Hessian of a coarse mesh over the same domain, which may be none. It serves until
  /// it does so badly, there is a factor, or the mesh is another one.
  void set_coarse(std::optional<CoarseHessian> coarse) { coarse_ = std::move(coarse); }
  /// `hessian`, as last assembled, for a finer mesh; nothing where there is neither a coarser mesh
  /// that served it nor a factor.
  std::optional<CoarseHessian> as_coarse(Interpolation to_finer, Hessian hessian) const;
  bool is_near(const HessianKind& kind) const {
    return is_near_ && cholesky_.has_factor() && kind == kind_;
  }

 private:
  std::optional<LocalSolve> solve_of_changed_nodes(const SparseSymmetric& matrix) const;
  std::optional<ConjugateGradientSolution> solve_from_coarse(const Hessian& hessian,
                                                             const Eigen::VectorXd& b,
                                                             double least_gain);

  Cholesky cholesky_;
  std::vector<double> stiffness_;  ///< by node, of the matrix of a large factor; else empty
  HessianKind kind_;
  std::optional<CoarseHessian> coarse_;
  ConjugateGradientRoom room_;
  bool is_of_mesh_ = false;  ///< the factor, by its vertices
  bool is_analyzed_ = false;
  bool is_own_ = false;                     ///< of ∇²E itself, in any precision
  bool is_near_ = false;                    ///< to ∇²E, as far as is known
  Precision roughest_ = Precision::single;  ///< that did
};

}  // namespace foldless
