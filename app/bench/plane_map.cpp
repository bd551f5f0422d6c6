// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/plane_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

/// 1 at 0, 0 from 1 on, once differentiable; its slope is nowhere steeper than 1.54.
double bump(double r) {
  if (r >= 1) return 0;
  const double s = 1 - r * r;
  return s * s;
}

Vec2 moved_by(const Twist& twist, const Vec2& p) {
  const Vec2 arm = p - twist.centre;
  const double distance = arm.norm();
  if (distance >= twist.radius) return p;
  const double r = std::max(0.0, (distance - twist.core) / (twist.radius - twist.core));
  return twist.centre + Eigen::Rotation2Dd(twist.angle * bump(r)) * arm;
}

Vec2 moved_by(const Shear& shear, const Vec2& p) {
  const Vec2 along = shear.offset.normalized();
  const Vec2 arm = p - shear.centre;
  const double distance = std::abs(along.x() * arm.y() - along.y() * arm.x());
  if (distance >= shear.width) return p;
  return p + bump(distance / shear.width) * shear.offset;
}

Vec2 moved_by(const Drag& drag, const Vec2& p) {
  const double r = (p - drag.centre).norm() / drag.radius;
  if (r >= 1) return p;
  return p + bump(r) * drag.offset;
}

}  // namespace

Vec2 moved(const PlaneMove& move, const Vec2& p) {
  return std::visit([&](const auto& one) { return moved_by(one, p); }, move);
}

Vec2 PlaneMap::operator()(Vec2 p) const {
  for (const PlaneMove& move : moves) p = moved(move, p);
  return p;
}

void add_long_drag(PlaneMap& map, const Drag& drag) {
  const int steps = std::max(1, static_cast<int>(std::ceil(2 * drag.offset.norm() / drag.radius)));
  const Vec2 step = drag.offset / steps;
  for (int i = 0; i < steps; ++i)
    map.moves.emplace_back(Drag{drag.centre + i * step, drag.radius, step});
}

}  // namespace foldless
