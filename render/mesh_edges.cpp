// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_edges.h"

#include <algorithm>

namespace foldless {
namespace {

/// Both indices in one number, the smaller first, so that equal edges sort together.
std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

/// An edge as a triangle has it.
struct Side {
  std::uint64_t key;
  int triangle;
};

}  // namespace

MeshEdges mesh_edges(std::span<const std::uint32_t> triangles) {
  std::vector<Side> sides;
  sides.reserve(triangles.size());
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back(
          {key_of(triangles[t + k], triangles[t + (k + 1) % 3]), static_cast<int>(t / 3)});
  std::ranges::sort(sides, {}, &Side::key);

  MeshEdges edges;
  for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
    while (next < sides.size() && sides[next].key == sides[first].key) ++next;
    const std::uint64_t key = sides[first].key;
    const bool is_interior = next - first > 1;
    auto& list = is_interior ? edges.interior : edges.boundary;
    list.push_back({static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key),
                    sides[first].triangle, is_interior ? sides[first + 1].triangle : -1});
  }
  return edges;
}

const MeshEdge* find_edge(const std::vector<MeshEdge>& edges, std::uint32_t a, std::uint32_t b) {
  const auto key = [](const MeshEdge& edge) { return key_of(edge.a, edge.b); };
  const auto it = std::ranges::lower_bound(edges, key_of(a, b), {}, key);
  return it != edges.end() && key(*it) == key_of(a, b) ? &*it : nullptr;
}

}  // namespace foldless
