// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <type_traits>

#include "core/energy/lanes.h"

namespace foldless {

/// χ and its derivatives with respect to det J = A′/A. [dimensionless]
template <class Real>
struct BarrierDerivatives {
  Real value = 0;
  Real first = 0;
  Real second = 0;
};

/// ψ_b = 1 − (1 − x)³ without the cancellation near x = 0.
template <class Real>
FOLDLESS_INLINED Real psi_b(const Real& x) {
  return x * (3 - x * (3 - x));
}

/// The barrier χ of eq. 4 [SKPSH13] on G = A′ − δA, seen as a function of det J alone: with
/// x = (det J − δ)/(1 − δ) it is 1/ψ_b(x) − 1, ψ_b = 1 − (1 − x)³, for 0 < x < 1, zero for x ≥ 1
/// and +∞ for x ≤ 0. Twice continuously differentiable at x = 1. `delta` is in (0, 1).
template <class Real>
FOLDLESS_INLINED Real barrier_value(const Real& det, double delta) {
  static_assert(!std::is_integral_v<Real>);
  const Real x = (det - delta) / Real(1 - delta);
  const Real chi = (1 - x) * (1 - x) * (1 - x) / psi_b(x);
  // Written so that a NaN counts as outside.
  const Real at_most_1 = select(x > 0, chi, std::numeric_limits<double>::infinity());
  return select(det >= 1, 0, at_most_1);
}

/// As above with derivatives. Precondition: det > delta.
template <class Real>
FOLDLESS_INLINED BarrierDerivatives<Real> barrier_derivatives(const Real& det, double delta) {
  const double slope = 1 / (1 - delta);
  const Real x = (det - delta) * slope;
  const Real y = 1 - x;
  const Real inverse = 1 / psi_b(x), inverse2 = inverse * inverse;
  const Real first = 3 * y * y * slope;
  const Real second = -6 * y * slope * slope;
  const auto is_beyond = det >= 1;
  return {select(is_beyond, 0, y * y * y * inverse), select(is_beyond, 0, -first * inverse2),
          select(is_beyond, 0, (2 * first * first * inverse - second) * inverse2)};
}

}  // namespace foldless
