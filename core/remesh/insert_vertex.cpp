// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/insert_vertex.h"

#include <utility>

#include "core/mesh/injective.h"

namespace foldless {
namespace {

/// Barycentric distance to an edge or a corner below which a split would make slivers.
constexpr double kNear = 0.05;

int split_at(MeshPair& mesh, int triangle, const Eigen::Vector3d& barycentric) {
  Eigen::Index opposite = 0;
  if (barycentric.minCoeff(&opposite) >= kNear) return mesh.split_triangle(triangle, barycentric);
  const Eigen::Vector3i corners = mesh.triangles().col(triangle);
  const Eigen::Index from = (opposite + 1) % 3, to = (opposite + 2) % 3;
  const int e = *mesh.find_edge(corners[from], corners[to]);
  const double t = barycentric[to] / (barycentric[from] + barycentric[to]);
  return mesh.split_edge(e, mesh.edge(e)[0] == corners[from] ? t : 1 - t);
}

std::size_t overlaps(const MeshPair& mesh) {
  const InjectivityChecker checker(mesh.triangles(), mesh.vertex_count());
  return checker.check(mesh.rest()).overlapping_boundary_vertices.size() +
         checker.check(mesh.deformed()).overlapping_boundary_vertices.size();
}

bool is_valid_at(const MeshPair& mesh, int vertex, double delta) {
  for (const int t : mesh.triangles_of_vertex(vertex)) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    if (!(signed_area(mesh.deformed(), corners) > delta * signed_area(mesh.rest(), corners)))
      return false;
  }
  return is_injective_inside(mesh.triangles(), mesh.rest(), mesh.deformed());
}

}  // namespace

int insert_vertex(MeshPair& mesh, int triangle, const Eigen::Vector3d& barycentric, double delta) {
  Eigen::Index nearest = 0;
  const double largest = barycentric.maxCoeff(&nearest);
  const int corner = mesh.triangles()(nearest, triangle);
  if (largest > 1 - kNear) return corner;
  MeshPair trial = mesh;
  const int vertex = split_at(trial, triangle, barycentric);
  // A map that overlaps at the boundary already may stay so.
  if (!is_valid_at(trial, vertex, delta) || overlaps(trial) > overlaps(mesh)) return corner;
  mesh = std::move(trial);
  return vertex;
}

}  // namespace foldless
