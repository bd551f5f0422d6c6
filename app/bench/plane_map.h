// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// Turns the plane about a point, by the whole angle within `core` and less and less up to
/// `radius`, beyond which nothing moves. A homeomorphism for every angle.
struct Twist {
  Vec2 centre;
  double radius;  ///< length
  double core;    ///< length, in [0, radius)
  double angle;   ///< radians, counter-clockwise
};

/// Moves every line of direction `offset` along itself, those within `width` of `centre`. A
/// homeomorphism for every offset.
struct Shear {
  Vec2 centre;
  Vec2 offset;   ///< of the line through the centre; not zero
  double width;  ///< length, > 0
};

/// Moves the points within `radius` of `centre`, the centre itself by `offset` and the others less.
/// A homeomorphism while |offset| ≤ 0.6 radius: the displacement then is Lipschitz with a constant
/// below 1.
struct Drag {
  Vec2 centre;
  double radius;  ///< length
  Vec2 offset;
};

/// An orientation-preserving homeomorphism of the plane that moves a bounded part of it, or for a
/// shear a strip.
using PlaneMove = std::variant<Twist, Shear, Drag>;

/// Where one move takes a point. Points out of its reach come back bit for bit.
Vec2 moved(const PlaneMove& move, const Vec2& p);

/// Moves one after the other: again an orientation-preserving homeomorphism.
struct PlaneMap {
  std::vector<PlaneMove> moves;

  Vec2 operator()(Vec2 p) const;
};

/// Adds the drags of half a radius or less that take `centre` to `centre + offset` in a straight
/// line; they stay within `radius` of it.
void add_long_drag(PlaneMap& map, const Drag& drag);

}  // namespace foldless
