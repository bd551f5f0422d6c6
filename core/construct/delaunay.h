// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/mesh/triangle.h"

namespace foldless {

/// The Delaunay triangulation of the convex hull of points, with exact predicates:
/// counter-clockwise triangles of them all. Nothing where two points coincide. The same points
/// always give the same triangles.
std::optional<Triangles> delaunay_triangles(const Points& points);

}  // namespace foldless
