// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/triangle.h"

namespace foldless {

/// A line in the plane of the rest mesh that a drawing is mirrored in, by two different points.
struct MirrorAxis {
  Vec2 from = Vec2::Zero();
  Vec2 to = Vec2::UnitY();

  bool operator==(const MirrorAxis&) const = default;
};

/// A displacement as a mirror in the axis shows it.
inline Vec2 mirrored_way(const MirrorAxis& axis, const Vec2& way) {
  const Vec2 along = (axis.to - axis.from).normalized();
  return 2 * along.dot(way) * along - way;
}

/// A point as a mirror in the axis shows it.
inline Vec2 mirrored(const MirrorAxis& axis, const Vec2& point) {
  return axis.from + mirrored_way(axis, point - axis.from);
}

}  // namespace foldless
