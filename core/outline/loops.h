// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outline/triangulate.h"

namespace foldless {

/// Signed area, positive when counter-clockwise. [length²]
double area_of(const Loop& loop);

/// True when the point is inside the loop; either where it is on an edge.
bool encloses(const Loop& loop, const Vec2& point);

}  // namespace foldless
