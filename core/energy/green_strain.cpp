// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/green_strain.h"

#include "core/energy/determinant.h"

namespace foldless {

double green_strain_value(const Mat2& J) {
  return (J.transpose() * J - Mat2::Identity()).squaredNorm();
}

DensityDerivatives green_strain_derivatives(const Mat2& J) {
  // ‖JᵀJ‖² = ‖J‖⁴ − 2 det², so ψ = ‖J‖⁴ − 2 det² − 2 ‖J‖² + 2.
  return {.value = green_strain_value(J),
          .norm = 4 * (J.squaredNorm() - 1),
          .det = -4 * determinant(J),
          .norm_norm = 8,
          .det_det = -4};
}

}  // namespace foldless
