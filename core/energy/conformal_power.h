// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// k^q with k = ‖J‖²/(2 det J) = ½ (σ₁/σ₂ + σ₂/σ₁): 1 where the map is conformal, infinite where it
/// folds. q is a power of two, 2 or more. Precondition: det J > 0.
struct ConformalPower {
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J, int q) {
    const Real k = squared_norm(J) / (2 * determinant(J));
    return k * k * power_less_two(k, q);
  }
  // ∇k = (j − k g)/det and ∇²k = (I − g ∇kᵀ − ∇k gᵀ − k D)/det.
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J, int q) {
    const Real inverse = 1 / determinant(J);
    const Real k = 0.5 * squared_norm(J) * inverse;
    const Real inverse2 = inverse * inverse;
    const Real less_two = power_less_two(k, q);
    const double n = q;
    return {.value = k * k * less_two,
            .norm = n * k * inverse * less_two,
            .det = -n * k * k * inverse * less_two,
            .norm_norm = n * (n - 1) * inverse2 * less_two,
            .norm_det = -n * n * k * inverse2 * less_two,
            .det_det = n * (n + 1) * k * k * inverse2 * less_two};
  }

 private:
  /// k^(q−2).
  template <class Real>
  FOLDLESS_INLINED static Real power_less_two(const Real& k, int q) {
    Real result = 1, power = k * k;
    for (int exponent = 2; exponent < q; exponent *= 2) {
      result = result * power;
      power = power * power;
    }
    return result;
  }
};

inline double conformal_power_value(const Mat2& J, int q) {
  return ConformalPower::value(matrix2(J), q);
}
inline DensityDerivatives conformal_power_derivatives(const Mat2& J, int q) {
  return ConformalPower::derivatives(matrix2(J), q);
}

}  // namespace foldless
