// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/mesh/triangle.h"

namespace foldless {

/// Value and derivatives of ψ with respect to vec(J) = (J₀₀, J₁₀, J₀₁, J₁₁). [dimensionless]
struct DensityDerivatives {
  double value = 0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
};

/// A distortion energy as its density ψ(J) per unit of rest area: one row of densities().
struct Density {
  std::string_view name;       ///< word in scene files and on the command line
  std::string_view title;      ///< words for the interface
  std::string_view citation;   ///< key of the README's bibliography
  double default_beta;         ///< β when the scene gives none (paper, section 5)
  bool paper_sums_unweighted;  ///< paper and [SKPSH13] sum ψ without the area A_t
  double (*value)(const Mat2& J);
  DensityDerivatives (*derivatives)(const Mat2& J);
};

}  // namespace foldless
