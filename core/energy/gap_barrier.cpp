// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy/gap_barrier.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace foldless {
namespace gap_angle {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRightAngle = std::numbers::pi / 2;

/// b and its derivatives by x, for 0 < x < 1.
struct Barrier {
  double value, first, second;
};
Barrier barrier(double x) {
  const double y = 1 - x, log = std::log(x), ratio = y / x;
  return {-y * y * log, y * (2 * log - ratio), -2 * log + ratio * (4 + ratio)};
}

Vec2 turned(const Vec2& a) { return {-a.y(), a.x()}; }

/// `of_square` (∇γ)(∇γ)ᵀ and the positive half of the angle's curvature, for one side; `sign` is
/// that of the angle of that side in γ.
Mat2 curvature_of(const Vec2& side, double of_square, double of_half, double sign) {
  const double square = side.squaredNorm();
  const Vec2 gradient = turned(side) / square;
  const Vec2 diagonal = (side + sign * turned(side)) / square;
  return of_square * gradient * gradient.transpose() + of_half * diagonal * diagonal.transpose();
}

}  // namespace gap_angle

GapSides sides_of(const BoundaryGap& gap, const Points& points) {
  return {points.col(gap.neighbours.next) - points.col(gap.vertex),
          points.col(gap.neighbours.previous) - points.col(gap.vertex)};
}

double angle_between(const GapSides& sides) {
  const double sine = cross(sides.previous, sides.next);
  const double cosine = sides.previous.dot(sides.next);
  return cosine > 0 && sine >= 0 ? std::atan2(sine, cosine) : gap_angle::kRightAngle;
}

double gap_barrier_value(const BoundaryGap& gap, const Points& u) {
  const double x = angle_between(sides_of(gap, u)) / gap.width;
  if (x >= 1) return 0;
  return x > 0 ? gap.area * gap_angle::barrier(x).value : gap_angle::kInfinity;
}

// γ is the angle of n less that of p, seen from v. With g and h its gradients by n and p,
// (g + h)(g + h)ᵀ ≼ 2 (g gᵀ + h hᵀ). The angle of n has the curvature −(d eᵀ + e dᵀ)/r² with d the
// direction and e that turned to the left; times b′ < 0 its positive half is
// |b′|/(2 r²) (d + e)(d + e)ᵀ, and for p with d − e.
GapBarrier gap_barrier(const BoundaryGap& gap, const Points& u) {
  using namespace gap_angle;
  const GapSides sides = sides_of(gap, u);
  const double x = angle_between(sides) / gap.width;
  GapBarrier result;
  if (x >= 1) return result;
  if (!(x > 0)) {
    result.value = kInfinity;
    return result;
  }
  const Barrier b = barrier(x);
  const double first = gap.area * b.first / gap.width;
  const double second = gap.area * b.second / (gap.width * gap.width);
  result.value = gap.area * b.value;
  result.by_next = first * turned(sides.next) / sides.next.squaredNorm();
  result.by_previous = -first * turned(sides.previous) / sides.previous.squaredNorm();
  result.next_curvature = curvature_of(sides.next, 2 * second, -first / 2, 1);
  result.previous_curvature = curvature_of(sides.previous, 2 * second, -first / 2, -1);
  return result;
}

}  // namespace foldless
