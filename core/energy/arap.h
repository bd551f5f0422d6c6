// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/density.h"

namespace foldless {

/// ψ = ½‖J − R(J)‖²_F with R the rotation closest to J [LZX*08]; exact derivatives, R is not
/// frozen. Precondition: J is not a pure reflection (σ₁ + σ₂ > 0).
double arap_value(const Mat2& J);
DensityDerivatives arap_derivatives(const Mat2& J);

}  // namespace foldless
