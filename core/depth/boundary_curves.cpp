// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/depth/boundary_curves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/mesh/components.h"

namespace foldless {
namespace {

/// A doubled area this small, in squares of the extent, may be nothing but rounding.
constexpr double kRounding = 1e-14;

struct Segment {
  Vec2 a, b;
  int from, to;
  double left, right, low, high;
};

bool may_cross(const Segment& s, const Segment& t) {
  const auto sides = [](const Segment& line, const Segment& other) {
    const Vec2 along = line.b - line.a, to_a = other.a - line.a, to_b = other.b - line.a;
    const double bound = kRounding * along.lpNorm<1>() * (to_a.lpNorm<1>() + to_b.lpNorm<1>());
    const double first = cross(along, to_a), second = cross(along, to_b);
    return !(std::min(first, second) > bound || std::max(first, second) < -bound);
  };
  return sides(s, t) && sides(t, s);
}

bool are_neighbours(const Segment& s, const Segment& t) {
  return s.from == t.from || s.from == t.to || s.to == t.from || s.to == t.to;
}

}  // namespace

BoundaryCurves::BoundaryCurves(const Triangles& triangles, int vertex_count)
    : neighbours_(boundary_neighbours(triangles, vertex_count)) {
  const std::vector<int> component = components_of(triangles, vertex_count);
  for (int v = 0; v < vertex_count; ++v)
    if (neighbours_[static_cast<std::size_t>(v)].are_there()) from_.push_back(v);
  const auto component_of = [&](int v) { return component[static_cast<std::size_t>(v)]; };
  std::ranges::stable_sort(from_, {}, component_of);
  for (const int v : from_) to_.push_back(neighbours_[static_cast<std::size_t>(v)].next);
  for (int i = 0; i < static_cast<int>(from_.size()); ++i) {
    const auto edge = static_cast<std::size_t>(i);
    if (i == 0 || component_of(from_[edge]) != component_of(from_[edge - 1]))
      components_.push_back({i, i});
    components_.back().end = i + 1;
  }
  std::vector<bool> is_used(static_cast<std::size_t>(vertex_count), false);
  for (const int v : triangles.reshaped()) is_used[static_cast<std::size_t>(v)] = true;
  const auto boundary_edges = static_cast<std::int64_t>(from_.size());
  euler_characteristic_ = std::ranges::count(is_used, true) -
                          (3 * triangles.cols() + boundary_edges) / 2 + triangles.cols();
}

bool BoundaryCurves::have_open_corners(const Points& points) const {
  double turns = 0;
  for (const int v : from_) {
    const BoundaryNeighbours& at = neighbours_[static_cast<std::size_t>(v)];
    const Vec2 in = points.col(v) - points.col(at.previous);
    const Vec2 out = points.col(at.next) - points.col(v);
    turns += std::atan2(cross(in, out), in.dot(out));
  }
  return std::llround(turns / (2 * std::numbers::pi)) == euler_characteristic_;
}

bool BoundaryCurves::meet(const Points& points) const {
  std::vector<Segment> segments(from_.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec2 a = points.col(from_[i]), b = points.col(to_[i]);
    segments[i] = {a,
                   b,
                   from_[i],
                   to_[i],
                   std::min(a.x(), b.x()),
                   std::max(a.x(), b.x()),
                   std::min(a.y(), b.y()),
                   std::max(a.y(), b.y())};
  }
  std::ranges::sort(segments, {}, &Segment::left);
  std::vector<const Segment*> open;
  for (const Segment& segment : segments) {
    std::erase_if(open, [&](const Segment* other) { return other->right < segment.left; });
    for (const Segment* other : open)
      if (other->low <= segment.high && segment.low <= other->high &&
          !are_neighbours(segment, *other) && may_cross(segment, *other))
        return true;
    open.push_back(&segment);
  }
  return false;
}

bool BoundaryCurves::are_nested(const Points& points) const {
  const auto covers = [&](const Curve& component, const Vec2& p) {
    bool is_inside = false;
    for (int i = component.first; i < component.end; ++i) {
      const auto edge = static_cast<std::size_t>(i);
      const Vec2 a = points.col(from_[edge]), b = points.col(to_[edge]);
      if ((a.y() > p.y()) == (b.y() > p.y())) continue;
      const double side = cross(b - a, p - a);
      if ((b.y() > a.y()) == (side > 0)) is_inside = !is_inside;
    }
    return is_inside;
  };
  std::vector<Eigen::AlignedBox2d> boxes(components_.size());
  for (std::size_t c = 0; c < boxes.size(); ++c)
    for (int i = components_[c].first; i < components_[c].end; ++i)
      boxes[c].extend(points.col(from_[static_cast<std::size_t>(i)]));
  for (std::size_t outer = 0; outer < boxes.size(); ++outer)
    for (std::size_t inner = 0; inner < boxes.size(); ++inner) {
      const Vec2 p = points.col(from_[static_cast<std::size_t>(components_[inner].first)]);
      if (inner != outer && boxes[outer].contains(boxes[inner]) && covers(components_[outer], p))
        return true;
    }
  return false;
}

}  // namespace foldless
