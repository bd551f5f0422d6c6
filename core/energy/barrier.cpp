// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/barrier.h"

#include <limits>

namespace foldless {
namespace {

/// ψ_b = 1 − (1 − x)³ without the cancellation near x = 0.
double psi_b(double x) { return x * (3 - x * (3 - x)); }

}  // namespace

double barrier_value(double det, double delta) {
  if (det >= 1) return 0;
  const double x = (det - delta) / (1 - delta);
  // Written so that a NaN counts as outside.
  if (!(x > 0)) return std::numeric_limits<double>::infinity();
  return (1 - x) * (1 - x) * (1 - x) / psi_b(x);
}

BarrierDerivatives barrier_derivatives(double det, double delta) {
  if (det >= 1) return {};
  const double slope = 1 / (1 - delta);
  const double x = (det - delta) * slope;
  const double y = 1 - x;
  const double inverse = 1 / psi_b(x), inverse2 = inverse * inverse;
  const double first = 3 * y * y * slope;
  const double second = -6 * y * slope * slope;
  return {y * y * y * inverse, -first * inverse2,
          (2 * first * first * inverse - second) * inverse2};
}

}  // namespace foldless
