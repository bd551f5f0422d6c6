// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_pair.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

#include "core/mesh/connectivity.h"

namespace foldless {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> counter{0};
  return ++counter;
}

}  // namespace

MeshPair::MeshPair(const Triangles& triangles, const Points& rest)
    : triangles_(triangles), rest_(rest), deformed_(rest_) {
  connect(connectivity_.own(), triangles, vertex_count());
  touch();
}

MeshPair::MeshPair(const Triangles& triangles, Points rest, Points deformed)
    : triangles_(triangles), rest_(std::move(rest)), deformed_(std::move(deformed)) {
  assert(rest_->cols() == deformed_->cols());
  connect(connectivity_.own(), triangles, vertex_count());
  touch();
}

void MeshPair::set_deformed(Points deformed) {
  assert(deformed.cols() == rest_->cols());
  deformed_.set(std::move(deformed));
}

Points MeshPair::exchange_deformed(Points deformed) {
  assert(deformed.cols() == rest_->cols());
  deformed_.own().swap(deformed);
  return deformed;
}

void MeshPair::set_positions(Points rest, Points deformed) {
  assert(rest.cols() == rest_->cols() && deformed.cols() == rest_->cols());
  rest_.set(std::move(rest));
  deformed_.set(std::move(deformed));
}

void MeshPair::move_vertex(int v, const Vec2& rest, const Vec2& deformed) {
  rest_.own().col(v) = rest;
  deformed_.own().col(v) = deformed;
  touch();
}

void MeshPair::set_stiffness(std::shared_ptr<const Stiffness> stiffness) {
  stiffness_ = std::move(stiffness);
}

Edge MeshPair::edge(int e) const {
  const HalfedgeHandle h = connectivity_->halfedge_handle(EdgeHandle(e), 0);
  const int a = connectivity_->from_vertex_handle(h).idx();
  const int b = connectivity_->to_vertex_handle(h).idx();
  return {std::min(a, b), std::max(a, b)};
}

std::optional<int> MeshPair::find_edge(int a, int b) const {
  const HalfedgeHandle h = connectivity_->find_halfedge(VertexHandle(a), VertexHandle(b));
  if (!h.is_valid()) return std::nullopt;
  return connectivity_->edge_handle(h).idx();
}

std::array<int, 3> MeshPair::edges_of_triangle(int t) const {
  std::array<int, 3> edges{};
  HalfedgeHandle h = connectivity_->halfedge_handle(FaceHandle(t));
  for (int& e : edges) {
    e = connectivity_->edge_handle(h).idx();
    h = connectivity_->next_halfedge_handle(h);
  }
  return edges;
}

bool MeshPair::is_boundary_edge(int e) const { return connectivity_->is_boundary(EdgeHandle(e)); }

bool MeshPair::is_boundary_vertex(int v) const {
  return connectivity_->is_boundary(VertexHandle(v));
}

bool MeshPair::is_isolated(int v) const { return connectivity_->is_isolated(VertexHandle(v)); }

Diamond MeshPair::diamond(int e) const {
  const HalfedgeHandle ab = connectivity_->halfedge_handle(EdgeHandle(e), 0);
  const HalfedgeHandle ba = connectivity_->opposite_halfedge_handle(ab);
  const auto apex = [this](HalfedgeHandle h) {
    return connectivity_->to_vertex_handle(connectivity_->next_halfedge_handle(h)).idx();
  };
  return {connectivity_->from_vertex_handle(ab).idx(),
          connectivity_->to_vertex_handle(ab).idx(),
          apex(ab),
          apex(ba),
          connectivity_->face_handle(ab).idx(),
          connectivity_->face_handle(ba).idx()};
}

std::vector<int> MeshPair::triangles_of_edge(int e) const {
  std::vector<int> triangles;
  for (const unsigned side : {0U, 1U}) {
    const FaceHandle f =
        connectivity_->face_handle(connectivity_->halfedge_handle(EdgeHandle(e), side));
    if (f.is_valid()) triangles.push_back(f.idx());
  }
  return triangles;
}

std::vector<int> MeshPair::triangles_of_vertex(int v) const {
  std::vector<int> triangles;
  // The outgoing halfedge of a boundary vertex is its boundary halfedge, so the walk is complete.
  const HalfedgeHandle first = connectivity_->halfedge_handle(VertexHandle(v));
  if (!first.is_valid()) return triangles;
  HalfedgeHandle h = first;
  do {
    const FaceHandle f = connectivity_->face_handle(h);
    if (f.is_valid()) triangles.push_back(f.idx());
    h = connectivity_->opposite_halfedge_handle(connectivity_->prev_halfedge_handle(h));
  } while (h != first);
  return triangles;
}

bool MeshPair::is_flip_legal(int e) const {
  return !is_boundary_edge(e) && connectivity_->is_flip_ok(EdgeHandle(e));
}

void MeshPair::flip(int e) {
  assert(is_flip_legal(e));
  connectivity_.own().flip(EdgeHandle(e));
  const HalfedgeHandle h = connectivity_->halfedge_handle(EdgeHandle(e), 0);
  read_triangle(connectivity_->face_handle(h));
  read_triangle(connectivity_->face_handle(connectivity_->opposite_halfedge_handle(h)));
  touch();
}

int MeshPair::split_edge(int e, double t) {
  assert(0 < t && t < 1);
  const auto [a, b] = edge(e);
  const int v = vertex_count();
  const auto between = [a = a, b = b, t](const Points& points) -> Vec2 {
    return points.col(a) + t * (points.col(b) - points.col(a));
  };
  append_vertex(between(*rest_), between(*deformed_));
  connectivity_.own().split(EdgeHandle(e), VertexHandle(v));
  read_triangles_round(v);
  return v;
}

int MeshPair::split_triangle(int t, const Eigen::Vector3d& barycentric) {
  const Eigen::Vector3i corners = triangles_->col(t);
  const auto at = [&](const Points& points) -> Vec2 {
    return points.col(corners[0]) * barycentric[0] + points.col(corners[1]) * barycentric[1] +
           points.col(corners[2]) * barycentric[2];
  };
  const int v = vertex_count();
  append_vertex(at(*rest_), at(*deformed_));
  connectivity_.own().split(FaceHandle(t), VertexHandle(v));
  read_triangles_round(v);
  return v;
}

void MeshPair::append_vertex(const Vec2& rest, const Vec2& deformed) {
  connectivity_.own().add_vertex();
  const auto append = [](Points& points, const Vec2& point) {
    points.conservativeResize(Eigen::NoChange, points.cols() + 1);
    points.rightCols<1>() = point;
  };
  append(rest_.own(), rest);
  append(deformed_.own(), deformed);
}

void MeshPair::read_triangle(FaceHandle f) {
  HalfedgeHandle h = connectivity_->halfedge_handle(f);
  auto corners = triangles_.own().col(f.idx());
  for (int corner = 0; corner < 3; ++corner) {
    corners[corner] = connectivity_->to_vertex_handle(h).idx();
    h = connectivity_->next_halfedge_handle(h);
  }
}

void MeshPair::read_triangles_round(int v) {
  triangles_.own().conservativeResize(Eigen::NoChange,
                                      static_cast<Eigen::Index>(connectivity_->n_faces()));
  for (const int t : triangles_of_vertex(v)) read_triangle(FaceHandle(t));
  touch();
}

void MeshPair::touch() { revision_ = next_revision(); }

}  // namespace foldless
