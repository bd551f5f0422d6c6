// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remesh/split_distorted.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/mesh/quality.h"

namespace foldless {
namespace {

constexpr double kMiddle = 0.5;

/// Of an edge of a triangle, both meshes together. [dimensionless]
double relative_length_squared(const MeshPair& mesh, const Edge& edge, int triangle) {
  double sum = 0;
  for (const Points* points : {&mesh.rest(), &mesh.deformed()})
    sum += (points->col(edge[1]) - points->col(edge[0])).squaredNorm() /
           signed_area(*points, mesh.triangles().col(triangle));
  return sum;
}

std::optional<Edge> edge_to_split(const MeshPair& mesh, int triangle,
                                  const SplitSettings& settings) {
  std::optional<Edge> longest;
  double most = 0;
  for (const int e : mesh.edges_of_triangle(triangle)) {
    const Edge edge = mesh.edge(e);
    const double length = relative_length_squared(mesh, edge, triangle);
    if (length <= most || !may_split(mesh, {e, kMiddle}, settings)) continue;
    most = length;
    longest = edge;
  }
  return longest;
}

/// Most distorted first.
std::vector<int> distorted_triangles(const MeshPair& mesh, double least) {
  std::vector<std::pair<double, int>> distorted;
  for (int t = 0; t < mesh.face_count(); ++t) {
    const Eigen::Vector3i corners = mesh.triangles().col(t);
    const double distortion = foldless::conformal_distortion(mesh.rest(), mesh.deformed(), corners);
    if (distortion >= least) distorted.emplace_back(-distortion, t);
  }
  std::ranges::sort(distorted);
  std::vector<int> triangles;
  triangles.reserve(distorted.size());
  for (const auto& [negative, t] : distorted) triangles.push_back(t);
  return triangles;
}

}  // namespace

int split_distorted(MeshPair& mesh, double least, const SplitSettings& settings) {
  std::set<Edge> edges;
  for (const int t : distorted_triangles(mesh, least)) {
    if (std::ssize(edges) >= settings.most_splits) break;
    if (const auto edge = edge_to_split(mesh, t, settings)) edges.insert(*edge);
  }
  int splits = 0;
  for (const Edge& edge : edges) {  // splitting one leaves the others
    const EdgeSplit split{*mesh.find_edge(edge[0], edge[1]), kMiddle};
    if (!may_split(mesh, split, settings)) continue;  // the triangles beside it are others now
    mesh.split_edge(split.edge, split.at);
    ++splits;
  }
  return splits;
}

}  // namespace foldless
