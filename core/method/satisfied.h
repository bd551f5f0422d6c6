// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// ε_c of Algorithm 1 in squared diagonals: the handles are at their targets when ‖P‖² ≤ 1e-10 D².
/// Converged runs reach about 1e-14 and blocked ones stay above 1e-3.
inline constexpr double kSatisfied = 1e-10;

/// D, the diagonal of the bounding box. [length]
inline double bounding_box_diagonal(const Points& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

}  // namespace foldless
