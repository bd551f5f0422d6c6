// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/winding.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// True when the direction from a to b has an angle in [0, π).
bool points_up(const Vec2& a, const Vec2& b) {
  return b.y() > a.y() || (b.y() == a.y() && b.x() > a.x());
}

/// Calls visit(a, b) for every edge.
template <typename Visit>
void for_each_edge(const Points& polygon, const Visit& visit) {
  Vec2 a = polygon.rightCols<1>();
  for (const Vec2 b : polygon.colwise()) {
    visit(a, b);
    a = b;
  }
}

}  // namespace

// Directions turn by less than π, or by −π, so that they pass the angle zero exactly when they
// change halves on the way up to the left, or on the way down to the right.
int turning_number(const Points& polygon) {
  int turns = 0;
  Vec2 before = polygon.col(polygon.cols() - 2);
  for_each_edge(polygon, [&](const Vec2& corner, const Vec2& next) {
    const bool was_up = points_up(before, corner), is_up = points_up(corner, next);
    const bool is_left = was_up != is_up && orientation(before, corner, next) > 0;
    if (is_left && is_up) ++turns;
    if (!is_left && was_up && !is_up) --turns;
    before = corner;
  });
  return turns;
}

// On a line the halves of both directions tell whether they are the same.
bool goes_straight_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  return orientation(a, b, c) == 0 && points_up(b, a) == points_up(b, c);
}

// Edges that meet a ray to the right count, those that go up as 1 and those that go down as −1. A
// start a little above or below p, but much less than it is to one side, meets no corner and lies
// on no edge; an edge through p is to the right of the starts on the left.
int least_winding_beside(const std::vector<Points>& polygons, const Vec2& p) {
  struct {
    int left = 0, right = 0;
  } above, below;
  for (const Points& polygon : polygons)
    for_each_edge(polygon, [&](const Vec2& a, const Vec2& b) {
      const bool is_above = (a.y() <= p.y()) != (b.y() <= p.y());
      const bool is_below = (a.y() < p.y()) != (b.y() < p.y());
      if (!is_above && !is_below) return;
      const int sign = a.y() < b.y() ? 1 : -1;
      const int side = sign * orientation(a, b, p);
      if (is_above && side >= 0) above.left += sign;
      if (is_above && side > 0) above.right += sign;
      if (is_below && side >= 0) below.left += sign;
      if (is_below && side > 0) below.right += sign;
    });
  return std::min({above.left, above.right, below.left, below.right});
}

bool is_area_negative(const std::vector<Points>& polygons) {
  double twice_area = 0, magnitude = 0, products = 0;
  for (const Points& polygon : polygons)
    for_each_edge(polygon, [&](const Vec2& a, const Vec2& b) {
      const double left = a.x() * b.y(), right = a.y() * b.x();
      twice_area += left - right;
      magnitude += std::abs(left) + std::abs(right);
      products += 2;
    });
  // A sum of n rounded products is off by at most n ε / (1 − n ε) of its magnitude with ε = 2⁻⁵³;
  // the factor of two covers the rounding of the magnitude, the addend underflow.
  return twice_area < -(products + 2) * (0x1p-52 * magnitude + 1e-300);
}

}  // namespace foldless
