// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "core/energy/constraints.h"
#include "core/handle.h"
#include "core/mesh/generate.h"

namespace foldless::test {

/// A bar of 4 by 0.2, its lower left corner in the origin.
inline Shape flat_bar() { return grid({.columns = 60, .rows = 3, .width = 4, .height = 0.2}); }

/// The bar bent to an arc that turns by so much on its whole length [rad]; the left end stays.
inline Points curled(const Points& rest, double angle) {
  if (angle == 0) return rest;
  const double radius = 4 / angle;
  Points points = rest;
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    const double turn = rest(0, v) / radius, distance = radius - rest(1, v);
    points.col(v) << distance * std::sin(turn), radius - distance * std::cos(turn);
    if (rest(0, v) == 0) points.col(v) = rest.col(v);
  }
  return points;
}

inline std::vector<Handle> left_end(const Points& rest) {
  std::vector<Handle> handles;
  for (int v = 0; v < static_cast<int>(rest.cols()); ++v)
    if (rest(0, v) == 0) handles.push_back({.id = v + 1, .vertex = v, .target = rest.col(v)});
  return handles;
}

inline Constraints left_end_held(const Points& rest) { return constraints_of(left_end(rest)); }

}  // namespace foldless::test
