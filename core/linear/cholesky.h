// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <memory>

#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// Sparse Cholesky factorization LLᵀ of a symmetric matrix, through CHOLMOD [CDHR08]: simplicial
/// for small systems, supernodal for large ones. The symbolic part is kept while the pattern
/// stands. A copy has the factor too.
class Cholesky {
 public:
  /// From this many unknowns on the supernodal factorization was measured to be faster.
  static constexpr int kSupernodalFrom = 800;

  Cholesky();
  ~Cholesky();
  Cholesky(const Cholesky& other);
  Cholesky& operator=(const Cholesky& other);
  Cholesky(Cholesky&&) noexcept;
  Cholesky& operator=(Cholesky&&) noexcept;

  /// Symbolic factorization of the pattern. The fill-reducing ordering is that of the vertex
  /// graph; with `keep_ordering` the previous one serves again (same number of unknowns).
  void analyze(const SparseSymmetric& matrix, bool keep_ordering = false);
  /// Factorizes matrix + shift·I; false when that is not positive definite.
  /// Precondition: analyze() was called with the same pattern.
  bool factorize(const SparseSymmetric& matrix, double shift = 0);
  /// True when analyze() was called.
  bool is_analyzed() const;
  /// True when the last factorization succeeded and nothing was analysed since.
  bool has_factor() const;
  /// Solves with the factor. Precondition: has_factor().
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace foldless
