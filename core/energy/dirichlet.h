// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J − I‖²_F, the Dirichlet energy of the displacement, as in [SKPSH13]: unlike ½‖J‖² it does
/// not shrink free boundaries; both have the same minimiser when the whole boundary is fixed.
double dirichlet_value(const Mat2& J);
DensityDerivatives dirichlet_derivatives(const Mat2& J);

}  // namespace foldless
