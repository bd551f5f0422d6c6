// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/snapshot.h"
#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/render_stats.h"
#include "render/view_options.h"

namespace foldless {

/// Edges of two triangles, of one, and those that the original mesh lacks.
enum class EdgeSet { interior, boundary, flipped };

/// A mesh on the graphics card: positions go there with every update, connectivity and rest
/// positions only when Snapshot::revision changed. All are floats relative to origin().
class MeshLayer {
 public:
  MeshLayer();

  /// Precondition: the snapshot has triangles and a rest mesh.
  void update(const Snapshot& snapshot, Pose pose);

  /// Draws with the program in use: attribute 0 is the position, 1 the rest position.
  void draw_triangles() const;
  /// Which triangle is drawn as the first, the second …: gl_PrimitiveID counts in this order.
  const std::vector<int>& order() const { return order_; }
  /// GL_LINES of a set of edges in the pose of the last update.
  void draw_edges(EdgeSet set) const;
  /// GL_LINES of the boundary of the rest mesh.
  void draw_rest_boundary() const;

  /// World point that stands at (0, 0) on the card: the middle of the rest mesh's box.
  glm::dvec2 origin() const { return 0.5 * (rest_box_.min + rest_box_.max); }
  const Box& rest_box() const { return rest_box_; }
  const RenderStats& stats() const { return stats_; }

 private:
  struct Range {
    std::size_t first = 0;  ///< index into the edge buffer
    std::size_t count = 0;  ///< indices
  };

  void upload_connectivity(const Snapshot& snapshot);
  void upload_edges(const Snapshot& snapshot, const std::vector<std::uint32_t>& triangles);
  void upload_points(const Buffer& buffer, const Points& points);
  static void draw_range(const VertexArray& lines, const Range& range);

  Buffer positions_, rest_, triangles_, edges_;
  VertexArray faces_;       ///< positions, rest, triangles
  VertexArray lines_;       ///< positions, edges
  VertexArray rest_lines_;  ///< rest, edges
  std::size_t triangle_indices_ = 0;
  std::vector<int> order_;
  std::array<Range, 3> ranges_;  ///< by EdgeSet
  Box rest_box_;
  std::optional<std::uint64_t> revision_;
  std::vector<Edge> flipped_edges_;  ///< those that are on the card
  std::vector<float> scratch_;
  RenderStats stats_;
};

}  // namespace foldless
