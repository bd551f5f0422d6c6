// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string_view>

#include "core/energy/matrix2.h"

namespace foldless {

/// ψ and its derivatives with respect to vec(J) = (J₀₀, J₁₀, J₀₁, J₁₁), as coefficients: an
/// isotropic ψ depends on J through ‖J‖² and det J alone, and with j = vec(J), g = ∂ det/∂j, D = ∂²
/// det/∂j²
///   ∇ψ  = norm j + det g + trace vec(I),
///   ∇²ψ = norm I + det D + norm_norm j jᵀ + norm_det (j gᵀ + g jᵀ) + det_det g gᵀ.
/// [dimensionless]
template <class Real>
struct DerivativesOf {
  Real value = 0;
  Real norm = 0;
  Real det = 0;
  Real norm_norm = 0;
  Real norm_det = 0;
  Real det_det = 0;
  Real trace = 0;  ///< the one term that may not be isotropic
};
using DensityDerivatives = DerivativesOf<double>;

/// Which formula.
enum class DensityKind { dirichlet, lscm, arap, green_strain, symmetric_dirichlet };

/// A distortion energy as its density ψ(J) per unit of rest area: one row of densities().
struct Density {
  std::string_view name;       ///< word in scene files and on the command line
  std::string_view title;      ///< words for the interface
  std::string_view citation;   ///< key of docs/bibliography.md
  double default_beta;         ///< β when the scene gives none (paper, section 5)
  bool paper_sums_unweighted;  ///< paper and [SKPSH13] sum ψ without the area A_t
  DensityKind kind;            ///< for loops over triangles
  double (*value)(const Mat2& J);
  DensityDerivatives (*derivatives)(const Mat2& J);
};

}  // namespace foldless
