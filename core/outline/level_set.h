// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/outline/scalar_grid.h"
#include "core/outline/triangulate.h"

namespace foldless {

/// The borders of the region where the field is greater than 0, with the region on their left when
/// y points up: boundaries counter-clockwise, holes clockwise. Marching squares: corners lie
/// between two cells' centres, where the field is 0 by linear interpolation. Coordinates in cells,
/// (0, 0) the lower left corner of the grid. Where two cells of the region touch at a corner alone,
/// they are joined if the mean of the four is positive. The region ends with the grid, exactly. No
/// loop touches itself or another. Same field, same loops in the same order.
std::vector<Loop> level_set(const ScalarGrid& field);

}  // namespace foldless
