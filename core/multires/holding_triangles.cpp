// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/holding_triangles.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// Coarse triangles that are looked at for one vertex.
constexpr int kMostTriangles = 1000;

class Search {
 public:
  explicit Search(const MeshPair& coarse)
      : coarse_(coarse), seen_(static_cast<std::size_t>(coarse.face_count()), -1) {}

  /// The triangle that holds p, sought from one near by, the nearest first: triangles of other
  /// sheets are far away. The nearest where rounding of the boundary leaves p outside of all.
  /// `vertex` tells one search from the other.
  int triangle_of(int vertex, const Vec2& p, int near_by) {
    heap_.assign(1, {depth(near_by, p), near_by});
    seen_[static_cast<std::size_t>(near_by)] = vertex;
    std::pair<double, int> best = heap_.front();
    for (int looked_at = 0; !heap_.empty() && looked_at < kMostTriangles; ++looked_at) {
      std::ranges::pop_heap(heap_);
      const std::pair<double, int> nearest = heap_.back();
      heap_.pop_back();
      best = std::max(best, nearest);
      if (holds(nearest.second, p)) return nearest.second;
      for (const int e : coarse_.edges_of_triangle(nearest.second))
        for (const int other : coarse_.triangles_of_edge(e)) {
          if (std::exchange(seen_[static_cast<std::size_t>(other)], vertex) == vertex) continue;
          heap_.emplace_back(depth(other, p), other);
          std::ranges::push_heap(heap_);
        }
    }
    return best.second;
  }

 private:
  /// Exact: a point on an edge that rounding puts outside of both triangles is found all the same.
  bool holds(int triangle, const Vec2& p) const {
    const Eigen::Vector3i t = coarse_.triangles().col(triangle);
    const Points& rest = coarse_.rest();
    return orientation(rest.col(t[0]), rest.col(t[1]), p) >= 0 &&
           orientation(rest.col(t[1]), rest.col(t[2]), p) >= 0 &&
           orientation(rest.col(t[2]), rest.col(t[0]), p) >= 0;
  }

  /// How far p is inside a triangle at rest, negative outside. [length]
  double depth(int triangle, const Vec2& p) const {
    const Eigen::Vector3i t = coarse_.triangles().col(triangle);
    double least = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 3; ++side) {
      const Vec2 a = coarse_.rest().col(t[side]), b = coarse_.rest().col(t[(side + 1) % 3]);
      least = std::min(least, 2 * signed_area(a, b, p) / (b - a).norm());
    }
    return least;
  }

  const MeshPair& coarse_;
  std::vector<int> seen_;  ///< the vertex for which a triangle was seen last
  std::vector<std::pair<double, int>> heap_;
};

std::vector<std::vector<int>> neighbours_of(const MeshPair& mesh) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(mesh.vertex_count()));
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto [a, b] = mesh.edge(e);
    neighbours[static_cast<std::size_t>(a)].push_back(b);
    neighbours[static_cast<std::size_t>(b)].push_back(a);
  }
  return neighbours;
}

}  // namespace

std::vector<int> holding_triangles(const CoarseMesh& coarse, const MeshPair& fine) {
  std::vector<int> triangles(static_cast<std::size_t>(fine.vertex_count()), -1);
  std::vector<int> found;  // breadth first from the vertices that both meshes have
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
    const int v = coarse.vertices[i];
    const std::vector<int> round = coarse.mesh.triangles_of_vertex(static_cast<int>(i));
    if (round.empty()) continue;
    triangles[static_cast<std::size_t>(v)] = round.front();
    found.push_back(v);
  }
  Search search(coarse.mesh);
  const std::vector<std::vector<int>> neighbours = neighbours_of(fine);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const auto near_by = static_cast<std::size_t>(found[next]);
    for (const int v : neighbours[near_by]) {
      int& triangle = triangles[static_cast<std::size_t>(v)];
      if (triangle >= 0) continue;
      triangle = search.triangle_of(v, fine.rest().col(v), triangles[near_by]);
      found.push_back(v);
    }
  }
  return triangles;
}

}  // namespace foldless
