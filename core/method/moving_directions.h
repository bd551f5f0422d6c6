// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/energy/constraints.h"
#include "core/iteration.h"
#include "core/remesh/split_edges.h"

namespace foldless {

/// How the inner loop ended: what eq. 12 asks.
struct ConvergenceInformation {
  Outcome outcome;           ///< CI of Table 1
  bool is_last_step_small;   ///< |s|_∞ < ε_f
  Points handles_before;     ///< the handles before the last update, 2 × #handles; may be empty
  Eigen::VectorXd gradient;  ///< ∇E where the loop ended, 2 #V
};

/// F_v of eq. 12 for every hard handle farther than `tolerance` from its target: −∂E_c/∂v after
/// gradient convergence; else −∇E(v) when the last step was small, and that step itself when it was
/// not. Handles are enough: the vertices round them follow. `u` is 2 × #V.
std::vector<MovingDirection> moving_directions(const Constraints& constraints, const Points& u,
                                               const ConvergenceInformation& information,
                                               double tolerance);

}  // namespace foldless
