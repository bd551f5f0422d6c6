// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/mesh_edges.h"

namespace foldless {

/// A corner of a triangle as the shader `wire` takes it, which finds for every pixel how far the
/// edges of its triangle are. Edge k of a triangle lies opposite its corner k.
struct WireCorner {
  glm::vec2 position;
  float height = 0;   ///< of the corner over the edge opposite
  glm::vec3 lengths;  ///< of the three edges; negative: the edge is not drawn
};

/// By triangle and corner: whether the edge opposite is one of `hidden`, which are boundary edges
/// of these triangles. `corners` holds three vertices a triangle.
std::vector<bool> hidden_edges(std::span<const std::uint32_t> corners,
                               std::span<const MeshEdge> hidden);

/// The corners of the triangles in this order. `positions` holds x and y of every vertex.
std::vector<WireCorner> wire_corners(std::span<const std::uint32_t> corners,
                                     const std::vector<int>& order,
                                     const std::vector<bool>& is_hidden,
                                     std::span<const float> positions);

}  // namespace foldless
