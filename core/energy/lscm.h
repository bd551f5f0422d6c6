// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J‖²_F − det J = ½(σ₁ − σ₂)², the conformal energy of [LPRM02], zero for similarities.
struct Lscm {
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    // ½‖J‖² − det J = ½((a − d)² + (b + c)²): no cancellation near a similarity.
    const Real stretch = J.a - J.d;
    const Real shear = J.b + J.c;
    return 0.5 * (stretch * stretch + shear * shear);
  }
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    return {.value = value(J), .norm = 1, .det = -1};
  }
};

}  // namespace foldless
