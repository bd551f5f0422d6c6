// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_edges.h"

#include <algorithm>

namespace foldless {
namespace {

/// Both indices in one number, the smaller first, so that equal edges sort together.
std::uint64_t key_of(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b);
}

}  // namespace

MeshEdges mesh_edges(std::span<const std::uint32_t> triangles) {
  std::vector<std::uint64_t> keys;
  keys.reserve(triangles.size());
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k)
      keys.push_back(key_of(triangles[t + k], triangles[t + (k + 1) % 3]));
  std::sort(keys.begin(), keys.end());

  MeshEdges edges;
  for (std::size_t first = 0, next = 0; first < keys.size(); first = next) {
    while (next < keys.size() && keys[next] == keys[first]) ++next;
    auto& list = next - first == 1 ? edges.boundary : edges.interior;
    list.push_back(static_cast<std::uint32_t>(keys[first] >> 32));
    list.push_back(static_cast<std::uint32_t>(keys[first]));
  }
  return edges;
}

}  // namespace foldless
