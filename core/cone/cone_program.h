// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <stop_token>
#include <vector>

#include "core/cone/cone_matrix.h"

namespace foldless {

enum class ConeStatus {
  solved,
  infeasible,  ///< z is a certificate: z_t ∈ Q, Gᵀz = 0 and gᵀz < 0, so no x has Gx + g ∈ Q
  not_converged,  ///< neither a solution nor a certificate was found
  cancelled
};

/// The end of a solve.
struct ConeSolution {
  ConeStatus status = ConeStatus::cancelled;
  Eigen::VectorXd x;     ///< 2 #nodes
  Eigen::Matrix3Xd z;    ///< dual variables, one column an element; or the certificate
  double objective = 0;  ///< ½xᵀPx + qᵀx
  int iterations = 0;
};

/// Primal-dual interior point for cone programs on one mesh connectivity: scaling of Nesterov and
/// Todd, predictor and corrector of Mehrotra [Van10]. An iteration costs one factorization and two
/// solves of a matrix with the pattern of the energies' Hessian; the analysis of that pattern is
/// kept from program to program. Copyable.
class ConeSolver {
 public:
  /// The unknown nodes and, for every element, the nodes of its corners.
  ConeSolver(int nodes, const std::vector<std::array<int, 3>>& elements)
      : matrix_(nodes, elements) {}

  /// Solves a program over the elements given before, in their order. The residuals of a solution
  /// are below `tolerance`: that of Gx + g = s absolutely, that of Px + q = Gᵀz relative to
  /// 1 + ‖q‖, and sᵀz, ten times that, relative to 1 + |objective|; where rounding stops the
  /// iteration before, below 1e-5. The token is looked at in factorizations and before each solve.
  ConeSolution solve(const ConeProgram& program, double tolerance, const std::stop_token& token);
  /// Factorizes P alone, for minimize_cost(); false when it is not positive definite, or the token
  /// stopped it.
  bool factorize_cost(const ConeProgram& program, const std::stop_token& token);
  /// The minimiser of the cost without the constraints. Precondition: factorize_cost() was the last
  /// call, succeeded, and was of a program with the same P. Less exact where the token stopped it.
  Eigen::VectorXd minimize_cost(const ConeProgram& program, const std::stop_token& token = {});

  /// Of all solves so far.
  int factorizations() const { return matrix_.factorizations(); }
  const StageTimes& times() const { return matrix_.times(); }

 private:
  ConeMatrix matrix_;
};

}  // namespace foldless
