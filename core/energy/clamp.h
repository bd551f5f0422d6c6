// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/energy/density.h"

namespace foldless {

/// What makes a ∇²ψ positive semidefinite when it is added: minus its negative part, as a sum over
/// an orthonormal basis of the 2×2 matrices J in which ∇²ψ is a 2×2 block and two numbers [SGK19].
struct NegativeCurvature {
  Mat2 rotation;             ///< R/√2, R the rotation closest to J
  Mat2 reflection;           ///< E/√2, E the reflection closest to J
  double of_rotation = 0;    ///< ≥ 0, of the block of those two
  double of_both = 0;        ///< the entry beside the diagonal
  double of_reflection = 0;  ///< ≥ 0
  double of_twist = 0;       ///< ≥ 0, of R/√2 turned by 90°
  double of_flip = 0;        ///< ≥ 0, of E/√2 turned by 90°
};

/// Nothing where ∇²ψ is positive semidefinite.
std::optional<NegativeCurvature> negative_curvature(const DensityDerivatives& density,
                                                    const Mat2& J);

}  // namespace foldless
