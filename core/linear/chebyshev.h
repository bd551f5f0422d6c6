// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/linear/sparse_symmetric.h"
#include "core/threads/unfilled_vector.h"

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
  /// Sets x to an approximation of A⁻¹ r that is linear in r and symmetric; `image` is room.
  /// Precondition: is_definite().
  void smooth(const Eigen::VectorXd& r, Eigen::VectorXd& x, Eigen::VectorXd& image) const;

 private:
  /// The inverse of a block of D: entries (0,0), (1,0) and (1,1).
  struct Inverse {
    double first, beside, second;
    Eigen::Vector2d operator*(const Eigen::Vector2d& x) const {
      return {first * x[0] + beside * x[1], beside * x[0] + second * x[1]};
    }
  };

  const SparseSymmetric& matrix_;
  UnfilledVector<Inverse> inverses_;  ///< of the nodes
  bool is_definite_ = true;
};

}  // namespace foldless
