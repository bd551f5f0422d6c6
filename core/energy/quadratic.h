// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <limits>

namespace foldless {

/// The roots of c + b t + a t², without cancellation; what there is not is not finite.
inline std::array<double, 2> roots(double a, double b, double c) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  return {q / a, c / q};
}

}  // namespace foldless
