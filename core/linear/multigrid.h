// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/linear/chebyshev.h"
#include "core/linear/cholesky.h"
#include "core/linear/interpolation.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless {

class CoarseGrid;

/// A V-cycle [BHM00] as a symmetric approximation of A⁻¹: smooths, corrects on a coarser grid,
/// smooths. Of conjugate gradients a preconditioner that needs no factor of A.
class VCycle {
 public:
  /// `A` and `coarser` outlive it; `coarser` is of as many fine nodes as A has.
  VCycle(const SparseSymmetric& A, CoarseGrid& coarser)
      : matrix_(A), smoother_(A), coarser_(coarser) {}

  /// False where A is seen not to be positive definite.
  bool is_definite() const { return smoother_.is_definite(); }
  /// Precondition: is_definite(), and so is what is coarser.
  Eigen::VectorXd operator()(const Eigen::VectorXd& r);

 private:
  const SparseSymmetric& matrix_;
  ChebyshevSmoother smoother_;
  CoarseGrid& coarser_;
};

/// The matrix of a coarse mesh as a finer one needs it: with how its unknowns become those of the
/// finer, and what approximates its inverse, a factor or another V-cycle. One thread at a time may
/// use it, with its team.
class CoarseGrid {
 public:
  /// Precondition: factor.has_factor().
  CoarseGrid(Interpolation to_finer, Cholesky factor);
  CoarseGrid(Interpolation to_finer, SparseSymmetric matrix, std::shared_ptr<CoarseGrid> coarser);
  CoarseGrid(const CoarseGrid&) = delete;
  CoarseGrid& operator=(const CoarseGrid&) = delete;

  /// False where its matrix is seen not to be positive definite: it does not serve.
  bool is_definite() const { return !cycle_ || cycle_->is_definite(); }
  /// About P C⁻¹ Pᵀ r, added to x, of the finer mesh. Precondition: is_definite().
  void correct(const Eigen::VectorXd& r, Eigen::VectorXd& x);

  /// Vectors that a cycle of the finer mesh works with, which the next one uses again.
  struct Room {
    Eigen::VectorXd left, image, smoothed;
  };
  Room& room_of_finer() { return room_; }

 private:
  Interpolation to_finer_;  ///< P
  Cholesky factor_;         ///< of C, or near it, where there is no cycle
  SparseSymmetric matrix_;  ///< C, where there is a cycle
  std::shared_ptr<CoarseGrid> coarser_;
  std::unique_ptr<VCycle> cycle_;
  Room room_;
};

}  // namespace foldless
