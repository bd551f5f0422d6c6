// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/random_numbers.h"
#include "core/mesh/triangle.h"

namespace foldless {

/// Polygons that bound an immersed disk by construction, with so many corners (24 or more, a column
/// each, counter-clockwise) and a box of diagonal 1 about the origin. Multiples of 2^-20.

/// Spikes round a centre.
Points star_polygon(RandomNumbers& random, int corners);
/// A bar with long thin teeth.
Points comb_polygon(RandomNumbers& random, int corners);
/// A band that winds up without touching itself.
Points spiral_polygon(RandomNumbers& random, int corners);
/// Random corners, joined so that no sides cross.
Points random_polygon(RandomNumbers& random, int corners);
/// The outline of a band that goes round 1.1 to 2.5 times and lies over itself.
Points wound_strip_polygon(RandomNumbers& random, int corners);
/// The outline of random triangles glued side to side, which often lie over each other.
Points glued_triangles_polygon(RandomNumbers& random, int corners);

}  // namespace foldless
