// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/split_edges.h"

#include <algorithm>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

Vec2 point_on(const Points& points, const Edge& edge, double at) {
  return points.col(edge[0]) + at * (points.col(edge[1]) - points.col(edge[0]));
}

bool has_long_halves(const Points& points, const Edge& edge, double at, double shortest) {
  const double length = (points.col(edge[1]) - points.col(edge[0])).norm();
  return std::min(at, 1 - at) * length >= shortest;
}

bool is_fixed(const MeshPair& mesh, int edge, std::span<const int> fixed_boundary) {
  return mesh.is_boundary_edge(edge) && std::ranges::all_of(mesh.edge(edge), [&](int v) {
           return std::ranges::binary_search(fixed_boundary, v);
         });
}

/// A triangle between one end of the edge, the new vertex and an apex, in both meshes.
struct NewTriangle {
  Eigen::Matrix<double, 2, 3> rest, deformed;
};

bool is_feasible(const NewTriangle& t, double delta) {
  const auto& [rest, deformed] = t;
  return orientation(rest.col(0), rest.col(1), rest.col(2)) > 0 &&
         orientation(deformed.col(0), deformed.col(1), deformed.col(2)) > 0 &&
         signed_area(deformed.col(0), deformed.col(1), deformed.col(2)) >
             delta * signed_area(rest.col(0), rest.col(1), rest.col(2));
}

}  // namespace

bool is_split_safe(const MeshPair& mesh, const EdgeSplit& split, const SplitSettings& settings) {
  const Edge edge = mesh.edge(split.edge);
  const Points &rest = mesh.rest(), &deformed = mesh.deformed();
  for (const Points* points : {&rest, &deformed})
    if (!has_long_halves(*points, edge, split.at, settings.shortest_edge)) return false;
  const Vec2 middle_rest = point_on(rest, edge, split.at);
  const Vec2 middle_deformed = point_on(deformed, edge, split.at);
  for (const int t : mesh.triangles_of_edge(split.edge))
    for (const int replaced : edge) {
      NewTriangle half;
      for (int corner = 0; corner < 3; ++corner) {
        const int v = mesh.triangles()(corner, t);
        half.rest.col(corner) = v == replaced ? middle_rest : Vec2(rest.col(v));
        half.deformed.col(corner) = v == replaced ? middle_deformed : Vec2(deformed.col(v));
      }
      if (!is_feasible(half, settings.delta)) return false;
    }
  return true;
}

bool may_split(const MeshPair& mesh, const EdgeSplit& split, const SplitSettings& settings) {
  return !is_fixed(mesh, split.edge, settings.fixed_boundary) &&
         is_split_safe(mesh, split, settings);
}

int split_edges(MeshPair& mesh, const std::vector<MovingDirection>& directions,
                const SplitSettings& settings) {
  int splits = 0;
  for (const auto& [vertex, direction] : directions) {
    const std::optional<Blockage> blockage = blockage_of(mesh, vertex, direction);
    if (!blockage) continue;
    // Splitting one edge renames none of the others, so the list stays good.
    for (const EdgeSplit& split : blockage->splits) {
      if (splits >= settings.most_splits) return splits;
      if (!may_split(mesh, split, settings)) continue;
      mesh.split_edge(split.edge, split.at);
      ++splits;
    }
  }
  return splits;
}

int split_all_edges(MeshPair& mesh, const SplitSettings& settings) {
  int splits = 0;
  for (int e = 0, count = mesh.edge_count(); e < count; ++e) {
    const EdgeSplit half{e, 0.5};
    if (!may_split(mesh, half, settings)) continue;
    mesh.split_edge(e, half.at);
    ++splits;
  }
  return splits;
}

}  // namespace foldless
