// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/outline/curve.h"
#include "core/outline/triangulate.h"

namespace foldless {

/// Closed curves that bound a figure: the boundary first, then its holes. All figures are about
/// 2 to 5 units wide, y upwards.
using Drawing = std::vector<Curve>;

/// A gingerbread man with his arms spread, standing on y = 0.
Drawing gingerbread();

/// An alligator from the side, looking to the right with its mouth open, standing on y = 0.
Drawing alligator();

/// A cowboy puppet with hat and boots, standing on y = 0.
Drawing cowboy();

/// A bar [−1.5, 1.5] × [−0.5, 0.5] with rounded ends and a round hole in the middle.
Drawing bar_with_hole();

/// The drawing as polygons of `points` corners altogether, spaced as evenly as its corners allow.
Outline sampled(const Drawing& drawing, int points);

}  // namespace foldless
