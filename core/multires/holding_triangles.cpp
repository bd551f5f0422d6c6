// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/multires/holding_triangles.h"

#include <span>

#include "core/multires/triangle_search.h"
#include "core/threads/team.h"

namespace foldless {
namespace {

/// Vertices that are sought by one task, with a search of its own.
constexpr std::ptrdiff_t kSoughtTogether = 4096;

/// The vertices that each one has an edge with.
class VertexNeighbours {
 public:
  explicit VertexNeighbours(const MeshPair& mesh)
      : end_(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0),
        vertices_(2 * static_cast<std::size_t>(mesh.edge_count())) {
    for (int e = 0; e < mesh.edge_count(); ++e)
      for (const int v : mesh.edge(e)) ++end_[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 1; v < end_.size(); ++v) end_[v] += end_[v - 1];
    std::vector<std::size_t> next(end_.begin(), end_.end() - 1);
    for (int e = 0; e < mesh.edge_count(); ++e) {
      const auto [a, b] = mesh.edge(e);
      vertices_[next[static_cast<std::size_t>(a)]++] = b;
      vertices_[next[static_cast<std::size_t>(b)]++] = a;
    }
  }

  std::span<const int> of(std::size_t v) const {
    return std::span(vertices_).subspan(end_[v], end_[v + 1] - end_[v]);
  }

 private:
  std::vector<std::size_t> end_;  ///< of the neighbours of the vertex before
  std::vector<int> vertices_;
};

/// A vertex whose triangle is sought from that of a neighbour.
struct Sought {
  int vertex, near_by;
};

}  // namespace

std::vector<int> holding_triangles(const CoarseMesh& coarse, const MeshPair& fine) {
  std::vector<int> triangles(static_cast<std::size_t>(fine.vertex_count()), -1);
  std::vector<bool> is_met(triangles.size(), false);
  std::vector<int> ring;  // breadth first from the vertices that both meshes have
  for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
    const auto v = static_cast<std::size_t>(coarse.vertices[i]);
    const std::vector<int> round = coarse.mesh.triangles_of_vertex(static_cast<int>(i));
    if (round.empty()) continue;
    triangles[v] = round.front();
    is_met[v] = true;
    ring.push_back(coarse.vertices[i]);
  }
  const VertexNeighbours neighbours(fine);
  std::vector<Sought> sought;
  while (!ring.empty()) {
    sought.clear();
    for (const int near_by : ring)
      for (const int v : neighbours.of(static_cast<std::size_t>(near_by))) {
        if (is_met[static_cast<std::size_t>(v)]) continue;
        is_met[static_cast<std::size_t>(v)] = true;
        sought.push_back({v, near_by});
      }
    in_ranges(std::ssize(sought), kSoughtTogether, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
      TriangleSearch search(coarse.mesh);
      for (const auto [v, near_by] : std::span(sought).subspan(begin, end - begin))
        triangles[static_cast<std::size_t>(v)] =
            search.triangle_of(fine.rest().col(v), triangles[static_cast<std::size_t>(near_by)]);
    });
    ring.clear();
    for (const Sought& one : sought) ring.push_back(one.vertex);
  }
  return triangles;
}

}  // namespace foldless
