// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/objective.h"

namespace foldless {

/// The first trial of a line search, as a part of the largest feasible step.
inline constexpr double kFirstTrial = 0.8;

/// Where a line search ended.
struct LineSearchResult {
  double step_length = 0;  ///< t in (0, 1], or 0 when no decrease was found
  Points u;                ///< the new constraints, 2 × #V; the old ones when t = 0
};

/// A line to search along.
struct Line {
  const Points& u;     ///< where it starts, 2 × #V
  const Points& step;  ///< its direction, 2 × #V
  double energy;       ///< E(u)
  double slope;        ///< ∇E·step, negative
};

/// Backtracks from min(1, 0.8 t_max) to an Armijo decrease (1e-4) of E along u + t·step. No
/// triangle reaches A′ = δA anywhere on the way: t_max is a bound along the whole line, so a path
/// of accepted steps never leaves the set of locally injective maps.
LineSearchResult line_search(const Objective& objective, const Energy& energy, const Line& line);

}  // namespace foldless
