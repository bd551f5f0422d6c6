// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/shapes.h"

#include <cmath>

namespace foldless {
namespace {

/// The back of the alligator as a row of scutes from the neck to the tail: each a tooth on the
/// spine, smaller towards the tail.
void append_scutes(const std::vector<Vec2>& spine, std::vector<ControlPoint>& points) {
  for (std::size_t i = 0; i + 1 < spine.size(); ++i) {
    const Vec2& a = spine[i];
    const Vec2 along = spine[i + 1] - a;
    const Vec2 outward(along.y(), -along.x());
    points.push_back({a, 0});
    points.push_back({a + 0.30 * along + 0.30 * outward, 1});
    points.push_back({a + 0.62 * along + 0.42 * outward, 1});
  }
  points.push_back({spine.back(), 0});
}

/// Teeth hanging from the line a → b: each a corner between two corners on the line.
void append_teeth(const Vec2& a, const Vec2& b, int count, std::vector<ControlPoint>& points) {
  const Vec2 step = (b - a) / (2 * count - 1);
  const Vec2 outward(step.y(), -step.x());
  for (int k = 0; k < count; ++k) {
    const Vec2 start = a + 2 * k * step;
    points.push_back({start, 0});
    points.push_back({start + 0.5 * step + 1.1 * outward, 0});
    points.push_back({start + step, 0});
  }
}

/// Three rounded toes from the heel forward.
void append_foot(const Vec2& heel, std::vector<ControlPoint>& points) {
  for (const Vec2& p :
       {Vec2(0.0, 0.05), Vec2(0.06, 0), Vec2(0.2, 0.0), Vec2(0.3, 0), Vec2(0.325, 0.02),
        Vec2(0.355, 0.0), Vec2(0.42, 0.0), Vec2(0.46, 0.03), Vec2(0.43, 0.075), Vec2(0.3, 0.11)})
    points.push_back({heel + p, 1});
}

}  // namespace

Drawing gingerbread() {
  return {rounded_polygon(mirrored({{{0, 0.80}, 0.11},
                                    {{0.17, 0.0}, 0.20},
                                    {{0.86, 0.0}, 0.28},
                                    {{0.50, 1.00}, 0.45},
                                    {{0.55, 1.32}, 0.13},
                                    {{1.28, 1.18}, 0.24},
                                    {{1.28, 1.74}, 0.25},
                                    {{0.22, 1.67}, 0},
                                    {{0.46, 1.85}, 0.42},
                                    {{0.46, 2.54}, 0.46}}))};
}

Drawing alligator() {
  std::vector<ControlPoint> points{{{-2.75, 0.72}, 0}, {{-2.35, 0.38}, 1}, {{-1.8, 0.24}, 1},
                                   {{-1.3, 0.23}, 1},  {{-1.06, 0.27}, 1}, {{-0.99, 0.18}, 1}};
  append_foot({-0.9, 0}, points);
  for (const Vec2& p :
       {Vec2(-0.52, 0.2), Vec2(-0.4, 0.27), Vec2(0, 0.22), Vec2(0.38, 0.25), Vec2(0.5, 0.2)})
    points.push_back({p, 1});
  append_foot({0.46, 0}, points);
  for (const Vec2& p : {Vec2(0.82, 0.2), Vec2(0.96, 0.32), Vec2(1.4, 0.36), Vec2(2.0, 0.36),
                        Vec2(2.42, 0.40), Vec2(2.5, 0.47), Vec2(2.42, 0.52)})
    points.push_back({p, 1});
  append_teeth({2.3, 0.51}, {1.5, 0.50}, 5, points);
  points.push_back({{1.16, 0.58}, 0});
  append_teeth({1.55, 0.69}, {2.36, 0.86}, 5, points);
  for (const Vec2& p : {Vec2(2.5, 0.90), Vec2(2.58, 0.99), Vec2(2.50, 1.09), Vec2(2.38, 1.07),
                        Vec2(2.2, 0.98), Vec2(1.8, 0.91), Vec2(1.5, 0.90), Vec2(1.38, 1.0),
                        Vec2(1.25, 1.10), Vec2(1.1, 1.03), Vec2(1.0, 0.92)})
    points.push_back({p, 1});
  append_scutes({{0.86, 0.86},
                 {0.68, 0.86},
                 {0.49, 0.87},
                 {0.29, 0.885},
                 {0.08, 0.89},
                 {-0.13, 0.885},
                 {-0.34, 0.87},
                 {-0.55, 0.84},
                 {-0.75, 0.79},
                 {-0.95, 0.73},
                 {-1.14, 0.66},
                 {-1.33, 0.59},
                 {-1.52, 0.53},
                 {-1.70, 0.49},
                 {-1.88, 0.465},
                 {-2.05, 0.465},
                 {-2.21, 0.48},
                 {-2.36, 0.52}},
                points);
  points.push_back({{-2.55, 0.61}, 1});
  return {smooth_curve(points)};
}

Drawing cowboy() {
  return {rounded_polygon(mirrored({{{0.10, 0.84}, 0},
                                    {{0.17, 0}, 0},
                                    {{0.78, 0}, 0.13},
                                    {{0.70, 0.28}, 0.12},
                                    {{0.52, 0.36}, 0.10},
                                    {{0.54, 1.05}, 0.25},
                                    {{0.45, 1.30}, 0.12},
                                    {{0.98, 1.03}, 0.17},
                                    {{1.26, 1.18}, 0.17},
                                    {{1.16, 1.51}, 0.17},
                                    {{0.52, 1.78}, 0.18},
                                    {{0.25, 1.75}, 0},
                                    {{0.48, 1.91}, 0.2},
                                    {{0.48, 2.18}, 0},
                                    {{0.84, 2.15}, 0.15},
                                    {{1.0, 2.52}, 0.09},
                                    {{0.51, 2.43}, 0},
                                    {{0.46, 2.97}, 0.22},
                                    {{0, 2.82}, 0.25}}))};
}

Drawing bar_with_hole() {
  return {rounded_polygon(
              {{{-1.5, -0.5}, 0.15}, {{1.5, -0.5}, 0.15}, {{1.5, 0.5}, 0.15}, {{-1.5, 0.5}, 0.15}}),
          circle({0, 0}, 0.27)};
}

Outline sampled(const Drawing& drawing, int points) {
  double total = 0;
  for (const Curve& curve : drawing) total += length_of(curve);
  Outline outline;
  int used = 0;
  double length = 0;
  for (const Curve& curve : drawing) {
    length += length_of(curve);
    const int up_to = static_cast<int>(std::lround(points * length / total));
    Loop loop = resample(curve, up_to - used);
    used = up_to;
    if (outline.boundary.empty())
      outline.boundary = std::move(loop);
    else
      outline.holes.push_back(std::move(loop));
  }
  return outline;
}

}  // namespace foldless
