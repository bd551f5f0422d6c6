// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// A smoother of A x = r: two steps of Chebyshev's semi-iteration from 0 with the diagonal blocks D
/// of A, of 2 × 2, after [ABHT03]. What it leaves is p(D⁻¹A) times the error, p least on the upper
/// three quarters of [0, 2.4] and |p| < 1 on (0, 3), where the eigenvalues of D⁻¹A are if A is a
/// sum of positive semidefinite blocks of three nodes, as (a + b + c)² ≤ 3 (a² + b² + c²).
class ChebyshevSmoother {
 public:
  /// `A` outlives it.
  explicit ChebyshevSmoother(const SparseSymmetric& A);

  /// False where a block of D is not positive definite, and then A is not; nothing can be smoothed.
  bool is_definite() const { return is_definite_; }
  /// An approximation of A⁻¹ r that is linear in r and symmetric. Precondition: is_definite().
  Eigen::VectorXd smoothed(const Eigen::VectorXd& r) const;

 private:
  /// The inverse of a block of D: entries (0,0), (1,0) and (1,1).
  struct Inverse {
    double first, beside, second;
    Eigen::Vector2d operator*(const Eigen::Vector2d& x) const {
      return {first * x[0] + beside * x[1], beside * x[0] + second * x[1]};
    }
  };

  const SparseSymmetric& matrix_;
  std::vector<Inverse> inverses_;  ///< of the nodes
  bool is_definite_ = true;
};

}  // namespace foldless
