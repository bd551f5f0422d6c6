// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/loops.h"

namespace foldless {

double area_of(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    twice += cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  return 0.5 * twice;
}

bool encloses(const Loop& loop, const Vec2& point) {
  bool is_inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const bool is_upward = b.y() > a.y();
    if ((cross(b - a, point - a) > 0) == is_upward) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace foldless
