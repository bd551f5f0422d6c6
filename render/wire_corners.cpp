// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/wire_corners.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace foldless {

std::vector<bool> hidden_edges(std::span<const std::uint32_t> corners,
                               std::span<const MeshEdge> hidden) {
  std::vector<bool> is_hidden(corners.size(), false);
  for (const MeshEdge& edge : hidden)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = 3 * static_cast<std::size_t>(edge.triangle) + k;
      if (corners[corner] != edge.a && corners[corner] != edge.b) is_hidden[corner] = true;
    }
  return is_hidden;
}

std::vector<WireCorner> wire_corners(std::span<const std::uint32_t> corners,
                                     const std::vector<int>& order,
                                     const std::vector<bool>& is_hidden,
                                     std::span<const float> positions) {
  std::vector<WireCorner> wire;
  wire.reserve(3 * order.size());
  for (const int triangle : order) {
    const std::size_t first = 3 * static_cast<std::size_t>(triangle);
    std::array<glm::vec2, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t place = 2 * std::size_t{corners[first + k]};
      p[k] = {positions[place], positions[place + 1]};
    }
    const glm::vec2 u = p[1] - p[0];
    const glm::vec2 v = p[2] - p[0];
    const float doubled_area = std::abs(u.x * v.y - u.y * v.x);
    const std::array<float, 3> lengths{glm::distance(p[1], p[2]), glm::length(v), glm::length(u)};
    glm::vec3 drawn;
    for (int k = 0; k < 3; ++k) {
      const auto edge = static_cast<std::size_t>(k);
      drawn[k] = is_hidden[first + edge] ? -1.0F : lengths[edge];
    }
    for (std::size_t k = 0; k < 3; ++k)
      wire.push_back({p[k], lengths[k] > 0 ? doubled_area / lengths[k] : 0.0F, drawn});
  }
  return wire;
}

}  // namespace foldless
