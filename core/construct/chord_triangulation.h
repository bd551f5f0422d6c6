// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/mesh/triangle.h"

namespace foldless {

/// What a triangle on the corners i < j < k of a polygon costs; infinite where it may not be used.
using PieceCost = std::function<double(int i, int j, int k)>;

/// The triangulation of a polygon on its corners alone that costs least, found by dynamic
/// programming over chords [Kli80]: n − 2 triangles i < j < k, 3 × (n − 2). Nothing exactly where
/// there is none without a triangle that may not be used. Precondition: corners ≥ 3. O(n³).
std::optional<Triangles> triangulate_by_chords(int corners, const PieceCost& cost);

}  // namespace foldless
