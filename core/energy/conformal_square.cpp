// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/conformal_square.h"

#include "core/energy/determinant.h"

namespace foldless {

double conformal_square_value(const Mat2& J) {
  const double k = J.squaredNorm() / (2 * determinant(J));
  return k * k;
}

// ∇k = (j − k g)/det and ∇²k = (I − g ∇kᵀ − ∇k gᵀ − k D)/det.
DensityDerivatives conformal_square_derivatives(const Mat2& J) {
  const double inverse = 1 / determinant(J);
  const double k = 0.5 * J.squaredNorm() * inverse;
  const double inverse2 = inverse * inverse;
  return {.value = k * k,
          .norm = 2 * k * inverse,
          .det = -2 * k * k * inverse,
          .norm_norm = 2 * inverse2,
          .norm_det = -4 * k * inverse2,
          .det_det = 6 * k * k * inverse2};
}

}  // namespace foldless
