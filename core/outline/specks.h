// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outline/scalar_grid.h"

namespace foldless {

/// Makes the values of small pieces negative and returns how many there were. A piece is a set of
/// positive cells that sides or corners connect; it is small with fewer than `cells` cells. The
/// largest piece stays.
int remove_specks(ScalarGrid& grid, double cells);

}  // namespace foldless
