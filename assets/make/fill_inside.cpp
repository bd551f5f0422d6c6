// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/fill_inside.h"

#include <algorithm>
#include <vector>

#include "core/mesh/mesh_pair.h"

namespace foldless::samples {
namespace {

constexpr double kRounding = 1e-9;
constexpr int kSmoothingRounds = 8;

/// Cosine of the angle at p in the triangle p, a, b.
double cosine(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (a - p).normalized().dot((b - p).normalized());
}

bool should_flip(const MeshPair& mesh, int e) {
  if (mesh.is_boundary_edge(e) || !mesh.is_flip_legal(e)) return false;
  const Diamond diamond = mesh.diamond(e);
  const Points& p = mesh.rest();
  const auto at = [&](int v) { return Vec2(p.col(v)); };
  // Angles that add up to more than 180 degrees: the edge is not Delaunay. The diamond of such an
  // edge is convex.
  return cosine(at(diamond.c), at(diamond.a), at(diamond.b)) +
             cosine(at(diamond.d), at(diamond.a), at(diamond.b)) <
         -kRounding;
}

void make_delaunay(MeshPair& mesh) {
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (int e = 0; e < mesh.edge_count(); ++e)
      if (should_flip(mesh, e)) {
        mesh.flip(e);
        is_done = false;
      }
  }
}

int longest_interior_edge(const MeshPair& mesh) {
  int longest = 0;
  double length = 0;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_boundary_edge(e)) continue;
    const auto [a, b] = mesh.edge(e);
    const double candidate = (mesh.rest().col(a) - mesh.rest().col(b)).norm();
    if (candidate > length + kRounding) {
      longest = e;
      length = candidate;
    }
  }
  return longest;
}

/// Moves a vertex to the middle of its neighbours, as far as its triangles stay well positive.
void centre(Points& points, const MeshPair& mesh, int v) {
  const std::vector<int> around = mesh.triangles_of_vertex(v);
  Vec2 sum = Vec2::Zero();
  double smallest = 1e300;
  for (const int t : around) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    for (const int corner : corners)
      if (corner != v) sum += points.col(corner) / 2;
    smallest = std::min(smallest, signed_area(points, corners));
  }
  const Vec2 old = points.col(v);
  points.col(v) = sum / static_cast<double>(around.size());
  for (const int t : around)
    if (signed_area(points, mesh.triangles().col(t)) < smallest / 2) {
      points.col(v) = old;
      return;
    }
}

void smooth(MeshPair& mesh) {
  Points points = mesh.rest();
  for (int v = 0; v < mesh.vertex_count(); ++v)
    if (!mesh.is_boundary_vertex(v)) centre(points, mesh, v);
  mesh.set_positions(points, points);
}

}  // namespace

Shape filled_inside(const Shape& shape, int vertices) {
  MeshPair mesh(shape.triangles, shape.rest);
  while (mesh.vertex_count() < vertices) {
    mesh.split_edge(longest_interior_edge(mesh), 0.5);
    make_delaunay(mesh);
  }
  for (int round = 0; round < kSmoothingRounds; ++round) {
    smooth(mesh);
    make_delaunay(mesh);
  }
  return {mesh.triangles(), mesh.rest()};
}

}  // namespace foldless::samples
