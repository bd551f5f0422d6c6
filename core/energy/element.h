// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "core/energy/energy_settings.h"
#include "core/mesh/mesh_pair.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// What the energy needs of a rest triangle.
struct RestElement {
  double area;                            ///< A > 0
  Eigen::Matrix<double, 2, 3> gradients;  ///< of the hat functions
  double stiffness;                       ///< factor on the distortion
};

/// Corners of a triangle, 2 × 3.
using Corners = Eigen::Matrix<double, 2, 3>;

/// Distortion and barrier of one triangle, weights included.
struct ElementEnergy {
  double distortion = 0;  ///< A ψ(J), times the stiffness
  double barrier = 0;     ///< β χ, infinite when A′ ≤ δA, and the conformal term
  double total() const { return distortion + barrier; }
};

/// As above with the gradient with respect to the corners (x₀, y₀, x₁, y₁, x₂, y₂).
struct ElementGradient {
  ElementEnergy energy;
  Eigen::Matrix<double, 6, 1> gradient;
};

/// As above with the Hessian.
struct ElementHessian {
  ElementEnergy energy;
  Eigen::Matrix<double, 6, 1> gradient;
  Eigen::Matrix<double, 6, 6> hessian;
};

RestElement rest_element(const Corners& rest);
/// With its stiffness: that of the mesh at the centroid. `t`: vertex indices, of any triangle.
RestElement rest_element(const MeshPair& mesh, const Eigen::Vector3i& t);
/// What the energy compares a triangle of M with.
RestElement reference_element(const EnergySettings& settings, const RestElement& rest);
RestElement reference_element(const EnergySettings& settings, const MeshPair& mesh,
                              const Eigen::Vector3i& t);
/// The corners of a triangle of a mesh.
inline Corners corners_of(const Points& points, const Eigen::Vector3i& triangle) {
  Corners corners;
  for (int corner = 0; corner < 3; ++corner) corners.col(corner) = points.col(triangle[corner]);
  return corners;
}
/// J = Σ u_j ∇φ_jᵀ, from edge vectors.
inline Mat2 deformation_gradient(const RestElement& rest, const Corners& deformed) {
  // The hat gradients add up to zero, so edge vectors do: no cancellation far from the origin.
  return (deformed.col(1) - deformed.col(0)) * rest.gradients.col(1).transpose() +
         (deformed.col(2) - deformed.col(0)) * rest.gradients.col(2).transpose();
}

ElementEnergy element_energy(const EnergySettings& settings, const RestElement& rest,
                             const Corners& deformed);
/// Precondition: A′ > δA.
ElementGradient element_gradient(const EnergySettings& settings, const RestElement& rest,
                                 const Corners& deformed);
/// The Hessian is without the part `clamping` of its negative curvature; see NegativeCurvature.
/// Precondition: A′ > δA.
ElementHessian element_hessian(const EnergySettings& settings, const RestElement& rest,
                               const Corners& deformed, double clamping = 0);

}  // namespace foldless
