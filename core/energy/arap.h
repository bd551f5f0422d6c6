// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J − R(J)‖²_F with R the rotation closest to J [LZX*08]; exact derivatives, R is not
/// frozen. Precondition: J is not a pure reflection (σ₁ + σ₂ > 0).
struct Arap {
  // With p = J₀₀ + J₁₁ and q = J₁₀ − J₀₁ the signed singular values add up to r = √(p² + q²), the
  // closest rotation is [p −q; q p]/r, and ½‖J − R‖² = ½‖J‖² − r + 1.
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    return value(J, inverse_of_sum(J));
  }
  // r² = ‖J‖² + 2 det, so ∇r = (j + g)/r and ∇²r = (I + D − ∇r ∇rᵀ)/r.
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    const Real inverse = inverse_of_sum(J);
    const Real cube = inverse * inverse * inverse;
    return {.value = value(J, inverse),
            .norm = 1 - inverse,
            .det = -inverse,
            .norm_norm = cube,
            .norm_det = cube,
            .det_det = cube};
  }

 private:
  /// 1/r.
  template <class Real>
  FOLDLESS_INLINED static Real inverse_of_sum(const Matrix2<Real>& J) {
    const Real p = J.a + J.d, q = J.b - J.c;
    return 1 / square_root(p * p + q * q);
  }
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J, const Real& inverse) {
    const Real cosine = (J.a + J.d) * inverse, sine = (J.b - J.c) * inverse;
    return 0.5 * squared_norm(Matrix2<Real>{J.a - cosine, J.b - sine, J.c + sine, J.d - cosine});
  }
};

}  // namespace foldless
