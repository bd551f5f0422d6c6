// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ‖JᵀJ − I‖²_F, Green's strain [HG00].
double green_strain_value(const Mat2& J);
DensityDerivatives green_strain_derivatives(const Mat2& J);

}  // namespace foldless
