// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solve/line_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace foldless {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 60;

}  // namespace

LineSearchResult line_search(const Objective& objective, const Energy& energy, const Line& line) {
  // Near the minimum the decrease drowns in the rounding of the sum.
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * std::abs(line.energy);
  const double t_max = objective.largest_step(energy.settings, line.u, line.step);
  double t = std::min(1.0, kFirstTrial * t_max);
  for (int halving = 0; halving < kMostHalvings; ++halving, t /= 2) {
    Points trial = line.u + t * line.step;
    const double trial_energy = objective.value(energy, trial).total();
    if (trial_energy <= line.energy + kArmijo * t * line.slope + rounding &&
        objective.are_gaps_open(energy.settings, line.u, trial))
      return {t, std::move(trial)};
  }
  return {0, line.u};
}

}  // namespace foldless
