// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/holding_triangles.h"

#include "core/multires/triangle_search.h"

namespace foldless {
namespace {

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
  TriangleSearch search(coarse.mesh);
  const std::vector<std::vector<int>> neighbours = neighbours_of(fine);
  for (std::size_t next = 0; next < found.size(); ++next) {
    const auto near_by = static_cast<std::size_t>(found[next]);
    for (const int v : neighbours[near_by]) {
      int& triangle = triangles[static_cast<std::size_t>(v)];
      if (triangle >= 0) continue;
      triangle = search.triangle_of(fine.rest().col(v), triangles[near_by]);
      found.push_back(v);
    }
  }
  return triangles;
}

}  // namespace foldless
