// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Two triangles that cover a common area, the smaller index first, or that only touch.
struct Overlap {
  int a = 0, b = 0;
  bool is_contact = false;  ///< they touch within rounding, and have no common corner

  bool operator==(const Overlap&) const = default;
};

/// Whether triangles with a common corner are looked at too: they lie over each other only where
/// the angles at a boundary vertex add up to more than 2π.
enum class CommonCorners { apart, may_overlap };

/// All pairs of triangles that cover a common area or touch, sorted. Precondition: the triangles
/// are counter-clockwise. About O(#F + #pairs) while their sizes are alike.
std::vector<Overlap> overlapping_triangles(const Triangles& triangles, const Points& points,
                                           CommonCorners corners);

}  // namespace foldless
