// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/mesh_at_rest.h"

#include <algorithm>

#include "core/mesh/orientation.h"
#include "core/remesh/insert_vertex.h"

namespace foldless {
namespace {

/// Barycentric coordinates of a rest position in a rest triangle.
Eigen::Vector3d rest_barycentric(const MeshPair& mesh, int triangle, const Vec2& p) {
  const Eigen::Vector3i t = mesh.triangles().col(triangle);
  const Vec2 a = mesh.rest().col(t[0]), b = mesh.rest().col(t[1]), c = mesh.rest().col(t[2]);
  return Eigen::Vector3d(signed_area(p, b, c), signed_area(a, p, c), signed_area(a, b, p)) /
         signed_area(a, b, c);
}

/// Rounding has put a new vertex beside the point that it was made for. There it goes where that is
/// valid, so that a mesh that is made anew from its rest positions is the same.
void put_at(MeshPair& mesh, int vertex, const Vec2& p) {
  Points moved = mesh.rest();
  moved.col(vertex) = p;
  for (const int t : mesh.triangles_of_vertex(vertex))
    if (orientation(moved, mesh.triangles().col(t)) <= 0) return;
  mesh = MeshPair(mesh.triangles(), moved);
}

/// Splits leave rest positions inside their old triangle up to rounding, so the triangle in which
/// the smallest coordinate is largest holds the point.
int vertex_at(MeshPair& mesh, const Vec2& p, double delta) {
  int best = 0;
  Eigen::Vector3d best_coordinates = Eigen::Vector3d::Constant(-1);
  for (int t = 0; t < mesh.face_count(); ++t) {
    const Eigen::Vector3d coordinates = rest_barycentric(mesh, t, p);
    if (t > 0 && coordinates.minCoeff() <= best_coordinates.minCoeff()) continue;
    best = t;
    best_coordinates = coordinates;
  }
  best_coordinates = best_coordinates.cwiseMax(0.0);
  const int before = mesh.vertex_count();
  const int vertex = insert_vertex(mesh, best, best_coordinates / best_coordinates.sum(), delta);
  if (vertex >= before) put_at(mesh, vertex, p);
  return vertex;
}

}  // namespace

MeshAtRest mesh_at_rest(const Shape& shape, const std::vector<Handle>& handles, const Points& rest,
                        double delta) {
  MeshAtRest result{MeshPair(shape.triangles, shape.rest), {}};
  for (Handle handle : handles) {
    if (handle.vertex >= shape.rest.cols())
      handle.vertex = vertex_at(result.mesh, rest.col(handle.vertex), delta);
    if (std::ranges::find(result.handles, handle.vertex, &Handle::vertex) == result.handles.end())
      result.handles.push_back(handle);
  }
  return result;
}

}  // namespace foldless
