// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J‖²_F − det J = ½(σ₁ − σ₂)², the conformal energy of [LPRM02], zero for similarities.
double lscm_value(const Mat2& J);
DensityDerivatives lscm_derivatives(const Mat2& J);

}  // namespace foldless
