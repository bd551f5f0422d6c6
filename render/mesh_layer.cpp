// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/mesh_layer.h"

#include <Eigen/Core>

#include "render/drawing_order.h"
#include "render/mesh_edges.h"

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

void attach_points(GLuint attribute, const Buffer& points) {
  glBindBuffer(GL_ARRAY_BUFFER, points.id());
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void attach_indices(const Buffer& indices) { glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id()); }

void append(std::vector<std::uint32_t>& list, const std::vector<std::uint32_t>& more) {
  list.insert(list.end(), more.begin(), more.end());
}

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

void MeshLayer::update(const Snapshot& snapshot, Pose pose) {
  if (revision_ != snapshot.revision || flipped_edges_ != flipped_of(snapshot))
    upload_connectivity(snapshot);
  upload_points(positions_, pose == Pose::rest ? *snapshot.rest : snapshot.deformed);
  ++stats_.position_uploads;
}

void MeshLayer::upload_connectivity(const Snapshot& snapshot) {
  rest_box_ = box_of(*snapshot.rest);
  upload_points(rest_, *snapshot.rest);
  const Triangles& triangles = *snapshot.triangles;
  order_ = drawing_order(triangles, *snapshot.rest);
  std::vector<std::uint32_t> indices;
  indices.reserve(static_cast<std::size_t>(triangles.size()));
  for (const int t : order_)
    for (const int v : triangles.col(t)) indices.push_back(static_cast<std::uint32_t>(v));
  triangle_indices_ = indices.size();
  glBindVertexArray(faces_.id());
  upload(GL_ELEMENT_ARRAY_BUFFER, indices, GL_DYNAMIC_DRAW);
  upload_edges(snapshot, indices);
  revision_ = snapshot.revision;
  ++stats_.index_uploads;
}

void MeshLayer::upload_edges(const Snapshot& snapshot,
                             const std::vector<std::uint32_t>& triangles) {
  MeshEdges edges = mesh_edges(triangles);
  flipped_edges_ = flipped_of(snapshot);
  std::vector<std::uint32_t> flipped;
  for (const Edge& edge : flipped_edges_) flipped.insert(flipped.end(), edge.begin(), edge.end());
  ranges_[0] = {0, edges.interior.size()};
  ranges_[1] = {ranges_[0].count, edges.boundary.size()};
  ranges_[2] = {ranges_[1].first + ranges_[1].count, flipped.size()};
  std::vector<std::uint32_t> all = std::move(edges.interior);
  append(all, edges.boundary);
  append(all, flipped);
  glBindVertexArray(lines_.id());
  upload(GL_ELEMENT_ARRAY_BUFFER, all, GL_DYNAMIC_DRAW);
}

void MeshLayer::upload_points(const Buffer& buffer, const Points& points) {
  scratch_.resize(static_cast<std::size_t>(points.size()));
  const Vec2 middle(origin().x, origin().y);
  FloatPoints(scratch_.data(), 2, points.cols()) = (points.colwise() - middle).cast<float>();
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  upload(GL_ARRAY_BUFFER, scratch_, GL_STREAM_DRAW);
}

void MeshLayer::draw_triangles() const {
  glBindVertexArray(faces_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangle_indices_), GL_UNSIGNED_INT, nullptr);
}

void MeshLayer::draw_range(const VertexArray& lines, const Range& range) {
  glBindVertexArray(lines.id());
  const auto* first = reinterpret_cast<const void*>(range.first * sizeof(std::uint32_t));
  glDrawElements(GL_LINES, static_cast<GLsizei>(range.count), GL_UNSIGNED_INT, first);
}

void MeshLayer::draw_edges(EdgeSet set) const {
  draw_range(lines_, ranges_[static_cast<std::size_t>(set)]);
}

void MeshLayer::draw_rest_boundary() const {
  draw_range(rest_lines_, ranges_[static_cast<std::size_t>(EdgeSet::boundary)]);
}

}  // namespace foldless
