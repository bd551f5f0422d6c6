// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "core/energy/densities.h"
#include "core/solve/damped_system.h"
#include "tests/support/dense_matrix.h"
#include "tests/support/meshes.h"

namespace foldless::test {

/// A square grid squeezed to a part of its size and bent a little. Under ARAP a triangle of less
/// than half of its size has negative curvature.
struct SqueezedGrid {
  explicit SqueezedGrid(double size) {
    const Fixture f = square_grid(4);
    Points u = size * f.rest;
    for (Eigen::Index v = 0; v < u.cols(); ++v)
      u.col(v) += 0.05 * size * Vec2(std::sin(2.0 * v), std::cos(3.0 * v));
    mesh = MeshPair(f.triangles, f.rest, u);
    std::vector<Handle> corners;
    for (const int v : {0, 3, 12, 15})
      corners.push_back({.id = v, .vertex = v, .target = f.rest.col(v)});
    energy.constraints = constraints_of(corners);
    energy.settings.density = find_density("arap");
    energy.settings.alpha = 1;
    energy.settings.beta = 0.1;
  }

  DampedSystem system() { return {mesh, energy.constraints, effort}; }

  MeshPair mesh;
  Energy energy;
  Effort effort;
};

/// ∇E and ∇²E as a dense matrix, without a NewtonSystem.
struct DenseNewton {
  DenseNewton(const MeshPair& mesh, const Energy& energy, double clamping = 0) {
    const Objective objective(mesh, energy.constraints);
    SparseSymmetric sparse = objective.hessian_pattern();
    gradient = objective.assemble(energy, mesh.deformed(), sparse, clamping).gradient;
    hessian = dense(sparse);
  }

  double smallest_eigenvalue() const {
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues()[0];
  }
  /// −(∇²E + μI)⁻¹ ∇E, 2 × #V.
  Points step(double mu = 0) const {
    const Eigen::MatrixXd shifted =
        hessian + mu * Eigen::MatrixXd::Identity(hessian.rows(), hessian.cols());
    return -shifted.ldlt().solve(gradient).reshaped(2, gradient.size() / 2);
  }

  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

/// The damping of [SKPSH13] by eigenvalues: what one iteration tries, and λ after it.
struct Damping {
  double lambda = 0.1;
  double mu = 0;     ///< the shift that made it positive definite
  int attempts = 0;  ///< factorizations, that of the plain matrix with them

  void iterate(double smallest_eigenvalue) {
    mu = 0;
    attempts = 1;
    if (smallest_eigenvalue > 0) {
      lambda = 1e-5;
      return;
    }
    for (mu = lambda, attempts = 2; mu + smallest_eigenvalue <= 0; mu += lambda, ++attempts)
      lambda *= 10;
    if (attempts == 2) lambda /= 10;
  }
};

}  // namespace foldless::test
