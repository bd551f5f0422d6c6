// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½(‖J‖²_F + ‖J⁻¹‖²_F), its own barrier [SS15]: grows without bound as det J → 0.
/// Precondition: det J > 0.
struct SymmetricDirichlet {
  // ‖J⁻¹‖² = ‖J‖²/det² in two dimensions, so ψ = ½ n (1 + det⁻²) with n = ‖J‖².
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    const Real det = determinant(J);
    return 0.5 * squared_norm(J) * (1 + 1 / (det * det));
  }
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    const Real n = squared_norm(J);
    const Real inverse = 1 / determinant(J);
    const Real det2 = inverse * inverse, det3 = det2 * inverse;
    return {.value = 0.5 * n * (1 + det2),
            .norm = 1 + det2,
            .det = -n * det3,
            .norm_det = -2 * det3,
            .det_det = 3 * n * det2 * det2};
  }
};

}  // namespace foldless
