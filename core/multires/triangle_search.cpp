// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/triangle_search.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Triangles that are looked at for one point.
constexpr int kMostTriangles = 1000;

}  // namespace

TriangleSearch::TriangleSearch(const MeshPair& mesh)
    : mesh_(mesh), seen_(static_cast<std::size_t>(mesh.face_count()), 0) {}

int TriangleSearch::triangle_of(const Vec2& p, int near_by) {
  ++searches_;
  heap_.assign(1, {distance(near_by, p), near_by});
  seen_[static_cast<std::size_t>(near_by)] = searches_;
  std::pair<double, int> best = heap_.front();
  for (int looked_at = 0; !heap_.empty() && looked_at < kMostTriangles; ++looked_at) {
    std::ranges::pop_heap(heap_, std::greater<>());
    const std::pair<double, int> nearest = heap_.back();
    heap_.pop_back();
    best = std::min(best, nearest);
    if (holds(nearest.second, p)) return nearest.second;
    for (const int e : mesh_.edges_of_triangle(nearest.second))
      for (const int other : mesh_.triangles_of_edge(e)) {
        if (std::exchange(seen_[static_cast<std::size_t>(other)], searches_) == searches_) continue;
        heap_.emplace_back(distance(other, p), other);
        std::ranges::push_heap(heap_, std::greater<>());
      }
  }
  return best.second;
}

/// Exact: a point on an edge that rounding puts outside of both triangles is found all the same.
bool TriangleSearch::holds(int triangle, const Vec2& p) const {
  const Eigen::Vector3i t = mesh_.triangles().col(triangle);
  const Points& rest = mesh_.rest();
  return orientation(rest.col(t[0]), rest.col(t[1]), p) >= 0 &&
         orientation(rest.col(t[1]), rest.col(t[2]), p) >= 0 &&
         orientation(rest.col(t[2]), rest.col(t[0]), p) >= 0;
}

/// Of p from a triangle at rest, 0 inside. Not from the lines of its sides: p may be near those of
/// a sliver that is far away. [length]
double TriangleSearch::distance(int triangle, const Vec2& p) const {
  const Eigen::Vector3i t = mesh_.triangles().col(triangle);
  bool is_inside = true;
  double least = std::numeric_limits<double>::infinity();
  for (int side = 0; side < 3; ++side) {
    const Vec2 a = mesh_.rest().col(t[side]), b = mesh_.rest().col(t[(side + 1) % 3]);
    if (signed_area(a, b, p) >= 0) continue;
    is_inside = false;
    const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - along * (b - a)).norm());
  }
  return is_inside ? 0 : least;
}

}  // namespace foldless
