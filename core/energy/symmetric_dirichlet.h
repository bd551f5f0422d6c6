// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½(‖J‖²_F + ‖J⁻¹‖²_F), its own barrier [SS15]: grows without bound as det J → 0.
/// Precondition: det J > 0.
double symmetric_dirichlet_value(const Mat2& J);
DensityDerivatives symmetric_dirichlet_derivatives(const Mat2& J);

}  // namespace foldless
