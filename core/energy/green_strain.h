// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ‖JᵀJ − I‖²_F, Green's strain [HG00].
struct GreenStrain {
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    const Matrix2<Real> square = transposed(J) * J;
    return squared_norm(Matrix2<Real>{square.a - 1, square.b, square.c, square.d - 1});
  }
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    // ‖JᵀJ‖² = ‖J‖⁴ − 2 det², so ψ = ‖J‖⁴ − 2 det² − 2 ‖J‖² + 2.
    return {.value = value(J),
            .norm = 4 * (squared_norm(J) - 1),
            .det = -4 * determinant(J),
            .norm_norm = 8,
            .det_det = -4};
  }
};

}  // namespace foldless
