// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// k² with k = ‖J‖²/(2 det J) = ½ (σ₁/σ₂ + σ₂/σ₁): 1 where the map is conformal, infinite where it
/// folds. Precondition: det J > 0.
double conformal_square_value(const Mat2& J);
/// As above with derivatives.
DensityDerivatives conformal_square_derivatives(const Mat2& J);

}  // namespace foldless
