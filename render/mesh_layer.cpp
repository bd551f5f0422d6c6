// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_layer.h"

#include <Eigen/Core>
#include <algorithm>
#include <utility>

#include "render/wire_corners.h"

namespace foldless {
namespace {

using FloatPoints = Eigen::Map<Eigen::Matrix2Xf>;

Box box_of(const Points& points) {
  if (points.cols() == 0) return {};
  const Vec2 low = points.rowwise().minCoeff();
  const Vec2 high = points.rowwise().maxCoeff();
  return {{low.x(), low.y()}, {high.x(), high.y()}};
}

const std::vector<Edge>& flipped_of(const Snapshot& snapshot) {
  static const std::vector<Edge> none;
  return snapshot.flipped_edges ? *snapshot.flipped_edges : none;
}

template <class T>
void upload(GLenum target, const std::vector<T>& values, GLenum usage) {
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), usage);
}

void upload_points(const Buffer& buffer, const std::vector<float>& values) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  upload(GL_ARRAY_BUFFER, values, GL_STREAM_DRAW);
}

void attach_points(GLuint attribute, const Buffer& points) {
  glBindBuffer(GL_ARRAY_BUFFER, points.id());
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void attach_indices(const Buffer& indices) { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id()); }

}  // namespace

MeshLayer::MeshLayer() {
  glBindVertexArray(faces_.id());
  attach_points(0, positions_);
  attach_points(1, rest_);
  attach_indices(triangles_);
  glBindVertexArray(lines_.id());
  attach_points(0, positions_);
  attach_indices(edges_);
  glBindVertexArray(rest_lines_.id());
  attach_points(0, rest_);
  attach_indices(edges_);
  glBindVertexArray(0);
}

void MeshLayer::set_parts(std::shared_ptr<const MeshParts> parts) {
  if (parts == mesh_parts_) return;
  mesh_parts_ = std::move(parts);
  paint_order_.set_parts(mesh_parts_);
  revision_.reset();
}

void MeshLayer::update(const Snapshot& snapshot, Pose pose) {
  const Points& points = pose == Pose::rest ? *snapshot.rest : snapshot.deformed;
  const bool is_new = revision_ != snapshot.revision || flipped_edges_ != flipped_of(snapshot);
  if (is_new) adopt_connectivity(snapshot);
  const std::vector<int>& sheets = paint_order_.layers(snapshot, points);
  if (is_new || sheets != sheets_) {
    sheets_ = sheets;
    upload_indices();
  }
  local_positions_ = local(points);
  upload_points(positions_, local_positions_);
  ++stats_.position_uploads;
}

void MeshLayer::adopt_connectivity(const Snapshot& snapshot) {
  rest_box_ = box_of(*snapshot.rest);
  const glm::dvec2 extent = rest_box_.max - rest_box_.min;
  local_ = {0.5 * (rest_box_.min + rest_box_.max), std::max(extent.x, extent.y)};
  upload_points(rest_, local(*snapshot.rest));
  corners_.clear();
  for (const int v : snapshot.triangles->reshaped())
    corners_.push_back(static_cast<std::uint32_t>(v));
  flipped_edges_ = flipped_of(snapshot);
  mesh_edges_ = edge_lists(corners_, flipped_edges_);
  is_boundary_ = hidden_edges(corners_, mesh_edges_[static_cast<std::size_t>(EdgeSet::boundary)]);
  const MeshParts none;
  const MeshParts& parts = mesh_parts_ ? *mesh_parts_ : none;
  parts_ = parts_of_triangles(*snapshot.triangles, static_cast<int>(snapshot.rest->cols()), parts);
  part_count_ = std::max<std::size_t>(1, parts.size());
  revision_ = snapshot.revision;
}

void MeshLayer::upload_indices() {
  LayerLists lists = lists_by_part(sheets_, parts_, part_count_);
  order_ = std::move(lists.order);
  triangle_starts_ = std::move(lists.first);
  std::vector<std::uint32_t> indices;
  indices.reserve(corners_.size());
  for (const int t : order_) {
    const auto first = corners_.begin() + 3 * static_cast<std::ptrdiff_t>(t);
    indices.insert(indices.end(), first, first + 3);
  }
  glBindVertexArray(faces_.id());
  upload(GL_ELEMENT_ARRAY_BUFFER, indices, GL_DYNAMIC_DRAW);
  indices.clear();
  for (const EdgeSet set : {EdgeSet::boundary, EdgeSet::flipped}) append_lines(indices, set);
  glBindVertexArray(lines_.id());
  upload(GL_ELEMENT_ARRAY_BUFFER, indices, GL_DYNAMIC_DRAW);
  ++stats_.index_uploads;
}

void MeshLayer::append_lines(std::vector<std::uint32_t>& lines, EdgeSet set) {
  const std::vector<MeshEdge>& edges = mesh_edges_[static_cast<std::size_t>(set)];
  LayerLists lists = edges_by_sheet(edges, sheets_);
  for (std::size_t& start : lists.first) start = lines.size() + 2 * start;
  for (const int e : lists.order) {
    const MeshEdge& edge = edges[static_cast<std::size_t>(e)];
    lines.push_back(edge.a);
    lines.push_back(edge.b);
  }
  edge_starts_[static_cast<std::size_t>(set)] = std::move(lists.first);
}

std::vector<float> MeshLayer::local(const Points& points) const {
  std::vector<float> values(static_cast<std::size_t>(points.size()));
  const Vec2 middle(local_.origin.x, local_.origin.y);
  FloatPoints(values.data(), 2, points.cols()) =
      ((points.colwise() - middle) / local_.unit).cast<float>();
  return values;
}

void MeshLayer::draw_triangles(std::size_t sheet) const {
  draw_range(triangle_starts_[sheet * part_count_], triangle_starts_[(sheet + 1) * part_count_]);
}

void MeshLayer::draw_triangles(std::size_t sheet, std::size_t part) const {
  const std::size_t place = sheet * part_count_ + part;
  draw_range(triangle_starts_[place], triangle_starts_[place + 1]);
}

void MeshLayer::draw_range(std::size_t first, std::size_t end) const {
  if (first == end) return;
  glBindVertexArray(faces_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (end - first)), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(3 * first * sizeof(std::uint32_t)));
}

void MeshLayer::draw_lines(const VertexArray& lines, std::size_t first, std::size_t end) {
  glBindVertexArray(lines.id());
  glDrawElements(GL_LINES, static_cast<GLsizei>(end - first), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void MeshLayer::draw_edges(EdgeSet set, std::size_t sheet) const {
  draw_lines(lines_, starts(set)[sheet], starts(set)[sheet + 1]);
}

void MeshLayer::draw_rest_boundary() const {
  draw_lines(rest_lines_, starts(EdgeSet::boundary).front(), starts(EdgeSet::boundary).back());
}

}  // namespace foldless
