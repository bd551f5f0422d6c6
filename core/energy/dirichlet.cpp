// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/dirichlet.h"

namespace foldless {

double dirichlet_value(const Mat2& J) { return 0.5 * (J - Mat2::Identity()).squaredNorm(); }

DensityDerivatives dirichlet_derivatives(const Mat2& J) {
  return {.value = dirichlet_value(J), .norm = 1, .trace = -1};
}

}  // namespace foldless
