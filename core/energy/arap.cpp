// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/arap.h"

#include <cmath>

namespace foldless {

// With p = J₀₀ + J₁₁ and q = J₁₀ − J₀₁ the signed singular values add up to r = √(p² + q²), the
// closest rotation is [p −q; q p]/r, and ½‖J − R‖² = ½‖J‖² − r + 1.

double arap_value(const Mat2& J) {
  const double p = J(0, 0) + J(1, 1);
  const double q = J(1, 0) - J(0, 1);
  const double inverse = 1 / std::sqrt(p * p + q * q);
  const double cosine = p * inverse, sine = q * inverse;
  Mat2 R;
  R << cosine, -sine, sine, cosine;
  return 0.5 * (J - R).squaredNorm();
}

// r² = ‖J‖² + 2 det, so ∇r = (j + g)/r and ∇²r = (I + D − ∇r ∇rᵀ)/r.
DensityDerivatives arap_derivatives(const Mat2& J) {
  const double p = J(0, 0) + J(1, 1);
  const double q = J(1, 0) - J(0, 1);
  const double inverse = 1 / std::sqrt(p * p + q * q);
  const double cube = inverse * inverse * inverse;
  return {.value = arap_value(J),
          .norm = 1 - inverse,
          .det = -inverse,
          .norm_norm = cube,
          .norm_det = cube,
          .det_det = cube};
}

}  // namespace foldless
