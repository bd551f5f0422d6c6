// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/vertices_of_splits.h"

#include <algorithm>

#include "core/energy/element.h"
#include "core/multires/triangle_search.h"

namespace foldless {
namespace {

/// Barycentric distance to an edge or a corner from which a point counts as lying on it.
constexpr double kNear = 1e-6;

Eigen::Vector3d barycentric(const Corners& corners, const Vec2& p) {
  Eigen::Vector3d areas;
  for (int i = 0; i < 3; ++i)
    areas[i] = signed_area(corners.col((i + 1) % 3), corners.col((i + 2) % 3), p);
  return areas / areas.sum();
}

}  // namespace

VerticesOfSplits::VerticesOfSplits(const CoarseMesh& coarse, MeshPair& fine)
    : coarse_(coarse), fine_(fine), vertices_(coarse.vertices) {
  vertices_.resize(static_cast<std::size_t>(coarse.mesh.vertex_count()), -1);
}

std::optional<int> VerticesOfSplits::vertex_at(int v) {
  int& vertex = vertices_[static_cast<std::size_t>(v)];
  if (vertex >= 0) return vertex;
  const Vec2 p = coarse_.mesh.rest().col(v);
  const int triangle = TriangleSearch(fine_).triangle_of(p, triangle_near(v));
  const Eigen::Vector3i corners = fine_.triangles().col(triangle);
  const Eigen::Vector3d at = barycentric(corners_of(fine_.rest(), corners), p);
  Eigen::Index nearest = 0;
  if (at.maxCoeff(&nearest) > 1 - kNear) return corners[nearest];
  const std::optional<int> made = make(v, triangle, at);
  if (made) vertex = *made;
  return made;
}

/// A fine triangle at the vertex of both meshes that is the fewest edges of the coarse one away.
int VerticesOfSplits::triangle_near(int v) const {
  const auto count = static_cast<int>(coarse_.vertices.size());
  std::vector<int> seen{v};
  for (std::size_t next = 0; next < seen.size(); ++next) {
    if (seen[next] < count)
      return fine_.triangles_of_vertex(vertices_[static_cast<std::size_t>(seen[next])]).front();
    for (const int t : coarse_.mesh.triangles_of_vertex(seen[next]))
      for (const int corner : coarse_.mesh.triangles().col(t))
        if (std::ranges::find(seen, corner) == seen.end()) seen.push_back(corner);
  }
  return 0;
}

std::optional<int> VerticesOfSplits::make(int v, int triangle, const Eigen::Vector3d& barycentric) {
  Eigen::Index opposite = 0;
  const bool is_on_edge = barycentric.minCoeff(&opposite) < kNear;
  const Eigen::Index from = (opposite + 1) % 3, to = (opposite + 2) % 3;
  const Eigen::Vector3i corners = fine_.triangles().col(triangle);
  const int e = *fine_.find_edge(corners[from], corners[to]);
  if (coarse_.mesh.is_boundary_vertex(v) != (is_on_edge && fine_.is_boundary_edge(e)))
    return std::nullopt;
  if (!is_on_edge) return fine_.split_triangle(triangle, barycentric);
  const double t = barycentric[to] / (barycentric[from] + barycentric[to]);
  return fine_.split_edge(e, fine_.edge(e)[0] == corners[from] ? t : 1 - t);
}

}  // namespace foldless
