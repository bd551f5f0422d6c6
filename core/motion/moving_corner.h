// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/mesh/triangle.h"

namespace foldless {

/// A point that moves at constant speed along a line while the time goes from 0 to 1, as viewers
/// move vertices between two frames.
struct MovingPoint {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
};

/// Three of them: the corner of a triangle, or that of a boundary with its two neighbours.
struct MovingCorner {
  MovingPoint apex, first, second;
};

/// The first moment in [0, 1] at which the triangle apex, first, second is not counter-clockwise;
/// nothing when it is all the time. Its area is a quadratic a + b t + c t²: whether there is such a
/// moment is decided exactly, and the moment is rounded. 0 when a coordinate is not finite.
std::optional<double> first_flat_moment(const MovingCorner& corner);

/// The first moment in [0, 1] at which both neighbours lie in one direction from the apex; nothing
/// when there is none, exact likewise. Precondition: neither neighbour is ever at the apex before.
std::optional<double> first_closed_moment(const MovingCorner& corner);

}  // namespace foldless
