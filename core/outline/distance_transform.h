// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outline/scalar_grid.h"

namespace foldless {

/// Distance of each cell's centre from the nearest centre of a cell that is greater than 0, in
/// cells; a huge number where there is none. Exact but for rounding, O(cells) [FH12].
ScalarGrid distance_transform(const ScalarGrid& cells);

}  // namespace foldless
