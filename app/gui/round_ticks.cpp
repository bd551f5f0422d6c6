// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/round_ticks.h"

#include <algorithm>
#include <cmath>

namespace foldless {

double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

std::vector<double> multiples(double step, double low, double high) {
  constexpr double kMostSteps = 1e14;
  std::vector<double> values;
  if (!(std::max(std::abs(low), std::abs(high)) < kMostSteps * step)) return values;
  for (double k = std::ceil(low / step); k * step <= high * (1 + 1e-9); ++k)
    values.push_back(k * step);
  return values;
}

}  // namespace foldless
