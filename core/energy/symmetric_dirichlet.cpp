// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/symmetric_dirichlet.h"

#include "core/energy/determinant.h"

namespace foldless {

// ‖J⁻¹‖² = ‖J‖²/det² in two dimensions, so ψ = ½ n (1 + det⁻²) with n = ‖J‖².

double symmetric_dirichlet_value(const Mat2& J) {
  const double det = determinant(J);
  return 0.5 * J.squaredNorm() * (1 + 1 / (det * det));
}

DensityDerivatives symmetric_dirichlet_derivatives(const Mat2& J) {
  const double n = J.squaredNorm();
  const double inverse = 1 / determinant(J);
  const double det2 = inverse * inverse, det3 = det2 * inverse;
  return {.value = 0.5 * n * (1 + det2),
          .norm = 1 + det2,
          .det = -n * det3,
          .norm_det = -2 * det3,
          .det_det = 3 * n * det2 * det2};
}

}  // namespace foldless
