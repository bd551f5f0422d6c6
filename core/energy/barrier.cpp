// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/barrier.h"

#include <limits>

namespace foldless {
namespace {

/// ψ_b = 1 − (1 − x)³ without the cancellation near x = 0.
double psi_b(double x) { return x * (3 - x * (3 - x)); }

}  // namespace

double barrier_value(double det, double delta) {
  const double x = (det - delta) / (1 - delta);
  if (x >= 1) return 0;
  // Written so that a NaN counts as outside.
  if (!(x > 0)) return std::numeric_limits<double>::infinity();
  return (1 - x) * (1 - x) * (1 - x) / psi_b(x);
}

BarrierDerivatives barrier_derivatives(double det, double delta) {
  const double x = (det - delta) / (1 - delta);
  if (x >= 1) return {};
  const double y = 1 - x;
  const double psi = psi_b(x);
  const double first = 3 * y * y / (1 - delta);
  const double second = -6 * y / ((1 - delta) * (1 - delta));
  return {y * y * y / psi, -first / (psi * psi),
          2 * first * first / (psi * psi * psi) - second / (psi * psi)};
}

}  // namespace foldless
