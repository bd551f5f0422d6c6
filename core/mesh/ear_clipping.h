// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// The longest polygon that clip_ears() takes: its time can grow with the cube.
inline constexpr int kMaxPolygonCorners = 1000;

/// Cuts a simple polygon, convex or not, into triangles of positive area by clipping ears
/// [Mei75], the one with the shortest diagonal first; predicates are exact. Triangles are indices
/// of corners in the polygon's own sense of rotation. Nothing when the polygon crosses or touches
/// itself, or has fewer than 3 or more than kMaxPolygonCorners corners.
std::optional<std::vector<std::array<int, 3>>> clip_ears(std::span<const Vec2> polygon);

}  // namespace foldless
