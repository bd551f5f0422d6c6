// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// How many full turns to the left the edges of a closed polygon make in one round: 1 for a simple
/// counter-clockwise one. A corner that goes straight back counts as half a turn to the right.
/// Corners are columns, the last is joined to the first, and neighbours differ. Exact.
int turning_number(const Points& polygon);

/// Whether a way from a over b to c goes straight back at b, however far. Neighbours differ. Exact.
bool goes_straight_back(const Vec2& a, const Vec2& b, const Vec2& c);

/// The least winding number of closed polygons together round the points beside p: arbitrarily
/// near to it, right and left, a little above and a little below. Off the polygons that is their
/// winding number round p. Exact. O(corners).
int least_winding_beside(const std::vector<Points>& polygons, const Vec2& p);

/// True only when the signed areas of the polygons, which are the integral of their winding number,
/// add up to less than zero whatever rounding did to the sum.
bool is_area_negative(const std::vector<Points>& polygons);

}  // namespace foldless
