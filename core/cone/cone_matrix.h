// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <stop_token>
#include <vector>

#include "core/linear/cholesky.h"
#include "core/linear/sparse_symmetric.h"
#include "core/stage_times.h"

namespace foldless {

/// What one triangle adds to a cone program, in terms of its corners' coordinates
/// c = (x₀, y₀, x₁, y₁, x₂, y₂): the cost ½cᵀPc + qᵀc and the constraint Gc + g ∈ Q. A half-plane
/// is the constraint whose last two rows of G and g are zero. Rows and columns of corners that are
/// not unknowns are not read.
struct ConeElement {
  std::array<int, 3> nodes;  ///< unknown node of each corner; −1: fixed, and part of q and g
  double weight = 1;         ///< how much the element counts in the starting point, > 0
  Eigen::Matrix<double, 6, 6> P = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> q = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 3, 6> G = Eigen::Matrix<double, 3, 6>::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
};

/// min ½xᵀPx + qᵀx subject to s_t = G_t x + g_t ∈ Q for every triangle t, where
/// Q = {s : s₀ ≥ ‖(s₁, s₂)‖}; x has one pair (x, y) per unknown node.
using ConeProgram = std::vector<ConeElement>;

/// Coordinates of a triangle's corners, (x₀, y₀, x₁, y₁, x₂, y₂).
using CornerVector = Eigen::Matrix<double, 6, 1>;

/// The corners of an element, zero where they are not unknowns.
CornerVector corners_of(const Eigen::VectorXd& x, const ConeElement& element);
/// Adds corner values to the unknowns of an element.
void add_corners(const CornerVector& values, const ConeElement& element, Eigen::VectorXd& x);

/// Symmetric M_t, one an element.
using MiddleMatrices = std::vector<Eigen::Matrix3d>;

/// Σ P_t + G_tᵀ M_t G_t over the elements of a program, and its Cholesky
/// factor. Copyable; a copy analyses the pattern anew.
class ConeMatrix {
 public:
  ConeMatrix(int nodes, const std::vector<std::array<int, 3>>& elements);

  /// Unknowns, 2 #nodes.
  int size() const { return matrix_.size(); }
  /// What may stop factorizations and refinements from now on.
  void obey(const std::stop_token& token) { cholesky_.obey(token); }
  bool is_stopped() const { return cholesky_.is_stopped(); }
  /// Assembles and factorizes; false when the matrix is not positive definite, or it was stopped.
  bool factorize(const ConeProgram& program, const MiddleMatrices& middle);
  /// Solves with the factor of these arguments and two rounds of iterative refinement. The residual
  /// is summed element by element, which keeps what cancels in the sum of the matrix. Less exact
  /// where it was stopped.
  Eigen::VectorXd solve(const ConeProgram& program, const MiddleMatrices& middle,
                        const Eigen::VectorXd& right);
  int factorizations() const { return factorizations_; }
  const StageTimes& times() const { return times_; }

 private:
  SparseSymmetric matrix_;
  Cholesky cholesky_;
  int factorizations_ = 0;
  StageTimes times_;
};

}  // namespace foldless
