// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/polygon_clip.h"

#include <algorithm>
#include <glm/common.hpp>

namespace foldless {
namespace {

/// What lies on the side of an axis-parallel line where `sign` · coordinate is at most sign · at.
Polygon cut(const Polygon& polygon, int axis, double at, double sign) {
  Polygon inside;
  inside.reserve(polygon.size() + 2);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double before = sign * (a[axis] - at), after = sign * (b[axis] - at);
    if (before <= 0) inside.push_back(a);
    if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
      glm::dvec2 crossing = a + (before / (before - after)) * (b - a);
      crossing[axis] = at;
      inside.push_back(crossing);
    }
  }
  return inside;
}

}  // namespace

Polygon clipped(Polygon polygon, const Box& box) {
  for (int axis = 0; axis < 2; ++axis) {
    polygon = cut(polygon, axis, box.max[axis], 1);
    polygon = cut(polygon, axis, box.min[axis], -1);
  }
  return polygon;
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> clipped_line(glm::dvec2 a, glm::dvec2 b,
                                                              const Box& box) {
  double first = 0, last = 1;
  const glm::dvec2 way = b - a;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0) {
      if (a[axis] < box.min[axis] || a[axis] > box.max[axis]) return std::nullopt;
      continue;
    }
    const double at_min = (box.min[axis] - a[axis]) / way[axis];
    const double at_max = (box.max[axis] - a[axis]) / way[axis];
    first = std::max(first, std::min(at_min, at_max));
    last = std::min(last, std::max(at_min, at_max));
  }
  if (first > last) return std::nullopt;
  return std::pair{first > 0 ? a + first * way : a, last < 1 ? a + last * way : b};
}

bool may_meet(const Polygon& polygon, const Box& box) {
  if (polygon.empty()) return false;
  glm::dvec2 low = polygon.front(), high = low;
  for (const glm::dvec2& p : polygon) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return low.x <= box.max.x && low.y <= box.max.y && high.x >= box.min.x && high.y >= box.min.y;
}

}  // namespace foldless
