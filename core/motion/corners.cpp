// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/corners.h"

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// All of b is on the right of a side of a, or on it.
bool is_parted_by_a_side(const Corners& a, const Corners& b) {
  for (int side = 0; side < 3; ++side) {
    const Vec2 from = a.col(side), to = a.col((side + 1) % 3);
    bool is_parted = true;
    for (int corner = 0; corner < 3 && is_parted; ++corner)
      is_parted = orientation(from, to, b.col(corner)) <= 0;
    if (is_parted) return true;
  }
  return false;
}

}  // namespace

bool share_area(const Corners& a, const Corners& b) {
  return !is_parted_by_a_side(a, b) && !is_parted_by_a_side(b, a);
}

Eigen::Vector3d barycentric(const Corners& corners, const Vec2& point) {
  const Vec2 a = corners.col(0), b = corners.col(1), c = corners.col(2);
  const Eigen::Vector3d areas(signed_area(b, c, point), signed_area(c, a, point),
                              signed_area(a, b, point));
  return areas / areas.sum();
}

}  // namespace foldless
