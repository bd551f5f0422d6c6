// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/linear/cholesky.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless {

/// When conjugate_gradients() ends.
struct ConjugateGradientSettings {
  double least_gain = 0;  ///< an iteration that lowers ½xᵀAx − bᵀx by less than this part of what
                          ///< all did is the last [NS90]
  int most_iterations = 0;  ///< > 0; the method gives up after so many
  /// They begin at the multiple of it that lowers ½xᵀAx − bᵀx most, which counts as what was done;
  /// at 0 where there is none, or of another size, or no multiple > 0 lowers it.
  const Eigen::VectorXd* guess = nullptr;
};

/// How conjugate_gradients() ended.
enum class ConjugateGradientEnd {
  converged,
  slow,       ///< gave up, also where the preconditioner gave no numbers
  stopped,    ///< as the factor is to obey
  indefinite  ///< met a direction p with pᵀAp ≤ 0
};

/// An approximate solution of A x = b.
struct ConjugateGradientSolution {
  Eigen::VectorXd x;  ///< of #rows; bᵀx > 0 unless b = 0 or the first direction was indefinite
  int iterations = 0;
  ConjugateGradientEnd end = ConjugateGradientEnd::converged;
};

/// Solves A x = b by conjugate gradients, preconditioned with the factor that `factor` holds, of a
/// positive definite matrix that is near A. A solve and a product with A an iteration.
/// Precondition: factor.has_factor(), of as many rows as A.
ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              Cholesky& factor,
                                              const ConjugateGradientSettings& settings);

}  // namespace foldless
