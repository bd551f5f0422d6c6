// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/sparse_symmetric.h"

namespace foldless {

class LocalSolve;

/// Vectors that the next call uses again, and that a copy makes for itself: memory that was not
/// used before is dear.
struct ConjugateGradientRoom {
  ConjugateGradientRoom() = default;
  ConjugateGradientRoom(const ConjugateGradientRoom&) {}
  ConjugateGradientRoom& operator=(const ConjugateGradientRoom&) { return *this; }

  Eigen::VectorXd residual, direction, image;
  std::vector<Eigen::VectorXd> images;  ///< A p of guesses p
};

/// When conjugate_gradients() ends.
struct ConjugateGradientSettings {
  double least_gain = 0;  ///< an iteration that lowers ½xᵀAx − bᵀx by less than this part of what
                          ///< all did is the last [NS90]
  int most_iterations = 0;  ///< > 0; the method gives up after so many
  /// They begin at the sum of multiples of these that lowers ½xᵀAx − bᵀx most, which counts as what
  /// was done. Those of another size, or that are nearly such a sum of those before them, count as
  /// none. A product with A each.
  std::span<const Eigen::VectorXd> guesses = {};
  /// The method gives up where an iteration but the first lowers ½xᵀAx − bᵀx by more than this part
  /// of what those before it did: many more would follow.
  double largest_gain = std::numeric_limits<double>::infinity();
  /// Of some nodes of A, where the residual is made zero in the beginning and stays so.
  LocalSolve* local = nullptr;
  std::stop_token token = {};             ///< once it is set the method stops
  ConjugateGradientRoom* room = nullptr;  ///< null: of its own
};

/// How conjugate_gradients() ended.
enum class ConjugateGradientEnd {
  converged,
  slow,       ///< gave up, also where the preconditioner gave no numbers
  stopped,    ///< as the settings say, or what the factor is to obey
  indefinite  ///< met a direction p with pᵀAp ≤ 0, or a residual r with rᵀM⁻¹r < 0
};

/// An approximate solution of A x = b.
struct ConjugateGradientSolution {
  Eigen::VectorXd x;  ///< of #rows; bᵀx > 0 unless b = 0 or the first direction was indefinite
  int iterations = 0;
  ConjugateGradientEnd end = ConjugateGradientEnd::converged;
};

/// r ↦ M⁻¹ r of a symmetric positive definite matrix M that is near A.
using Preconditioner = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Solves A x = b by preconditioned conjugate gradients. A product with A an iteration, and M⁻¹ r.
ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              const Preconditioner& precondition,
                                              const ConjugateGradientSettings& settings);

/// The same, preconditioned with the factor that `factor` holds; what that is to obey stops the
/// method too. Precondition: factor.has_factor(), of as many rows as A.
ConjugateGradientSolution conjugate_gradients(const SparseSymmetric& A, const Eigen::VectorXd& b,
                                              Cholesky& factor,
                                              const ConjugateGradientSettings& settings);

}  // namespace foldless
