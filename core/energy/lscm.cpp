// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/lscm.h"

namespace foldless {

double lscm_value(const Mat2& J) {
  // ½‖J‖² − det J = ½((a − d)² + (b + c)²): no cancellation near a similarity.
  const double stretch = J(0, 0) - J(1, 1);
  const double shear = J(1, 0) + J(0, 1);
  return 0.5 * (stretch * stretch + shear * shear);
}

DensityDerivatives lscm_derivatives(const Mat2& J) {
  return {.value = lscm_value(J), .norm = 1, .det = -1};
}

}  // namespace foldless
