// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// k² with k = ‖J‖²/(2 det J) = ½ (σ₁/σ₂ + σ₂/σ₁): 1 where the map is conformal, infinite where it
/// folds. Precondition: det J > 0.
struct ConformalSquare {
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    const Real k = squared_norm(J) / (2 * determinant(J));
    return k * k;
  }
  // ∇k = (j − k g)/det and ∇²k = (I − g ∇kᵀ − ∇k gᵀ − k D)/det.
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    const Real inverse = 1 / determinant(J);
    const Real k = 0.5 * squared_norm(J) * inverse;
    const Real inverse2 = inverse * inverse;
    return {.value = k * k,
            .norm = 2 * k * inverse,
            .det = -2 * k * k * inverse,
            .norm_norm = 2 * inverse2,
            .norm_det = -4 * k * inverse2,
            .det_det = 6 * k * k * inverse2};
  }
};

inline double conformal_square_value(const Mat2& J) { return ConformalSquare::value(matrix2(J)); }
inline DensityDerivatives conformal_square_derivatives(const Mat2& J) {
  return ConformalSquare::derivatives(matrix2(J));
}

}  // namespace foldless
