// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J − I‖²_F, the Dirichlet energy of the displacement, as in [SKPSH13]: unlike ½‖J‖² it does
/// not shrink free boundaries; both have the same minimiser when the whole boundary is fixed.
struct Dirichlet {
  template <class Real>
  FOLDLESS_INLINED static Real value(const Matrix2<Real>& J) {
    return 0.5 * squared_norm(Matrix2<Real>{J.a - 1, J.b, J.c, J.d - 1});
  }
  template <class Real>
  FOLDLESS_INLINED static DerivativesOf<Real> derivatives(const Matrix2<Real>& J) {
    return {.value = value(J), .norm = 1, .trace = -1};
  }
};

}  // namespace foldless
