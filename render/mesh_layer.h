// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "core/depth/paint_order.h"
#include "core/snapshot.h"
#include "render/camera.h"
#include "render/gl_objects.h"
#include "render/mesh_sheets.h"
#include "render/render_stats.h"
#include "render/view_options.h"

namespace foldless {

/// A mesh on the graphics card: positions go there with every update, connectivity and rest
/// positions only when Snapshot::revision changed, and indices also when other sheets lie in front.
/// All are floats in the frame local(). It is painted in sheets, 0 at the back, each with its
/// triangles and then its edges, so that nothing shows through what lies in front of it.
class MeshLayer {
 public:
  MeshLayer();

  /// The parts of the meshes to come; null: none, which counts as one.
  void set_parts(std::shared_ptr<const MeshParts> parts);

  /// Precondition: the snapshot has triangles and a rest mesh.
  void update(const Snapshot& snapshot, Pose pose);

  /// At least one.
  std::size_t sheet_count() const { return (triangle_starts_.size() - 1) / part_count_; }
  std::size_t part_count() const { return part_count_; }
  /// Draws with the program in use: attribute 0 is the position, 1 the rest position.
  void draw_triangles(std::size_t sheet) const;
  /// Those of one part, if there are any.
  void draw_triangles(std::size_t sheet, std::size_t part) const;
  bool has_triangles(std::size_t sheet, std::size_t part) const {
    const std::size_t place = sheet * part_count_ + part;
    return triangle_starts_[place] < triangle_starts_[place + 1];
  }
  /// Which triangle is drawn as the first, the second …; gl_PrimitiveID counts in this order, from
  /// 0 in every sheet.
  const std::vector<int>& order() const { return order_; }
  std::size_t triangle_count(std::size_t sheet) const {
    return first_triangle(sheet + 1) - first_triangle(sheet);
  }
  /// The vertices of the triangles, three by three.
  const std::vector<std::uint32_t>& corners() const { return corners_; }
  /// By corners(): whether the edge of the triangle opposite the corner is a boundary edge.
  const std::vector<bool>& is_boundary() const { return is_boundary_; }
  /// x and y of every vertex in the pose of the last update, in the frame local().
  const std::vector<float>& local_positions() const { return local_positions_; }
  /// Place in order() of a sheet's first triangle.
  std::size_t first_triangle(std::size_t sheet) const {
    return triangle_starts_[sheet * part_count_];
  }
  /// GL_LINES of the boundary or of the flipped edges in the pose of the last update; those inside
  /// are drawn by the triangles, see WireLayer. An edge of two sheets belongs to
  /// the one in front.
  void draw_edges(EdgeSet set, std::size_t sheet) const;
  /// GL_LINES of the boundary of the rest mesh.
  void draw_rest_boundary() const;
  /// See vertices_by_sheet() of the mesh.
  std::vector<std::vector<int>> sheet_vertices() const {
    return vertices_by_sheet(corners_, sheets_);
  }

  /// The middle of the rest mesh's box is at (0, 0) on the card, its larger side is 1 long.
  const LocalFrame& local() const { return local_; }
  const Box& rest_box() const { return rest_box_; }
  const RenderStats& stats() const { return stats_; }

 private:
  void adopt_connectivity(const Snapshot& snapshot);
  void upload_indices();
  void draw_range(std::size_t first, std::size_t end) const;
  void append_lines(std::vector<std::uint32_t>& lines, EdgeSet set);
  std::vector<float> local(const Points& points) const;
  static void draw_lines(const VertexArray& lines, std::size_t first, std::size_t end);
  const std::vector<std::size_t>& starts(EdgeSet set) const {
    return edge_starts_[static_cast<std::size_t>(set)];
  }

  Buffer positions_, rest_, triangles_, edges_;
  VertexArray faces_;       ///< positions, rest, triangles
  VertexArray lines_;       ///< positions, edges
  VertexArray rest_lines_;  ///< rest, edges
  PaintOrder paint_order_;
  std::shared_ptr<const MeshParts> mesh_parts_;
  std::vector<int> parts_;  ///< of every triangle
  std::size_t part_count_ = 1;
  std::vector<int> sheets_;  ///< of every triangle, as it is on the card
  std::vector<int> order_;
  /// In order_, of the parts of the first sheet, of those of the second, …
  std::vector<std::size_t> triangle_starts_{0, 0};
  std::array<std::vector<std::size_t>, 3> edge_starts_;  ///< by EdgeSet, in the edge buffer
  std::vector<std::uint32_t> corners_;                   ///< three a triangle
  EdgeLists mesh_edges_;
  std::vector<bool> is_boundary_;  ///< by corners_
  Box rest_box_;
  LocalFrame local_;
  std::optional<std::uint64_t> revision_;
  std::vector<Edge> flipped_edges_;  ///< those that are on the card
  std::vector<float> local_positions_;
  RenderStats stats_;
};

}  // namespace foldless
