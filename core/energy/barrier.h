// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foldless {

/// χ and its derivatives with respect to det J = A′/A. [dimensionless]
struct BarrierDerivatives {
  double value = 0;
  double first = 0;
  double second = 0;
};

/// The barrier χ of eq. 4 [SKPSH13] on G = A′ − δA, seen as a function of det J alone: with
/// x = (det J − δ)/(1 − δ) it is 1/ψ_b(x) − 1, ψ_b = 1 − (1 − x)³, for 0 < x < 1, zero for x ≥ 1
/// and +∞ for x ≤ 0. Twice continuously differentiable at x = 1. `delta` is in (0, 1).
double barrier_value(double det, double delta);
/// As above with derivatives. Precondition: det > delta.
BarrierDerivatives barrier_derivatives(double det, double delta);

}  // namespace foldless
