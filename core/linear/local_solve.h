// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// Solves for the unknowns of some nodes, S, while all others stand: with the factor of A_SS, the
/// rows and columns of A at S.
///
/// Where A differs from a factorized M at S alone, conjugate gradients whose residual is zero at S
/// from the beginning need few iterations with M: a multiplicative Schwarz method [TW05] of S and
/// the whole.
class LocalSolve {
 public:
  /// `nodes`, which is S, are in an order of elimination with little fill.
  LocalSolve(const SparseSymmetric& A, const std::vector<int>& nodes);

  /// False where A_SS, and A with it, is not positive definite. What follows needs it to be.
  bool is_definite() const { return factor_.has_factor(); }
  /// Adds to x the y, zero outside of S, that makes the residual r zero at S, and takes A y from r.
  /// Returns by how much ½xᵀAx − bᵀx falls.
  double correct(Eigen::VectorXd& x, Eigen::VectorXd& r);
  /// Changes x at S so that A x is zero there.
  void make_conjugate(Eigen::VectorXd& x);

 private:
  /// A block of the rows of A at S.
  struct Block {
    int row;     ///< which node of S
    int column;  ///< a node of A
    Eigen::Matrix2d value;
  };

  std::vector<int> nodes_;
  std::vector<Block> rows_;
  Cholesky factor_;  ///< of A_SS
};

/// The nodes and those that share a block with them, ascending.
std::vector<int> with_neighbours(const SparseSymmetric& A, const std::vector<int>& nodes);

}  // namespace foldless
