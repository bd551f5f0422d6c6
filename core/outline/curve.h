// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"
#include "core/outline/triangulate.h"

namespace foldless {

/// A closed curve as a dense polygon, and the indices of its points that are corners: resampling
/// keeps those and is free to move the others along the curve.
struct Curve {
  Loop points;
  std::vector<int> corners;  ///< increasing indices into points; may be empty
};

/// A control point of a drawing.
struct ControlPoint {
  Vec2 position;
  double radius = 0;  ///< rounded_polygon: of the arc; smooth_curve: 0 for a sharp corner
};

/// The closed polygon with every corner rounded by a circular arc of its radius, or by the
/// largest that its edges leave room for; radius 0 stays a corner. At least 3 points.
Curve rounded_polygon(const std::vector<ControlPoint>& points);

/// The closed centripetal Catmull-Rom curve through the points [Yuksel et al. 11]; points of
/// radius 0 are corners, where the curve breaks. At least 3 points.
Curve smooth_curve(const std::vector<ControlPoint>& points);

/// A circle, counter-clockwise.
Curve circle(const Vec2& centre, double radius);

/// The points of a half drawing from bottom to top (x ≥ 0), followed by their mirror images from
/// top to bottom; points on the axis x = 0 are not repeated.
std::vector<ControlPoint> mirrored(const std::vector<ControlPoint>& right_half);

/// Length of the curve.
double length_of(const Curve& curve);

/// `count` points spaced as evenly as the corners allow, all corners among them; the first is
/// points[0], or the first corner. Precondition: count ≥ 3 and ≥ the number of corners.
Loop resample(const Curve& curve, int count);

}  // namespace foldless
