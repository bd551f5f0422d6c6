// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/element.h"

namespace foldless {

/// Distortion and barrier of a triangle with their derivatives by moves of its corner 0 in both
/// meshes, (X, Y) at rest and (x, y) deformed.
struct MovedCorner {
  double energy = 0;
  Eigen::Vector4d gradient = Eigen::Vector4d::Zero();
  Eigen::Matrix4d hessian = Eigen::Matrix4d::Zero();
};

/// The derivatives by (X, Y) are the configurational force of r-adaption [TO04]: a move of X by s
/// changes A by the factor 1 + s·∇φ₀ and J by −J s ∇φ₀ᵀ. Of A ψ(J) the Hessian is exact but for
/// the part `clamping` of the negative curvature of ψ; of what is not weighted by A it is that
/// without the change of ∇φ₀. Preconditions: A′ > δA, compared with the rest triangle.
MovedCorner moved_corner(const EnergySettings& settings, const RestElement& rest,
                         const Corners& deformed, double clamping = 0);

}  // namespace foldless
