// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_pair.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <utility>

namespace foldless {
namespace {

std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> counter{0};
  return ++counter;
}

}  // namespace

MeshPair::MeshPair(const Triangles& triangles, const Points& rest)
    : MeshPair(triangles, rest, rest) {}

MeshPair::MeshPair(const Triangles& triangles, Points rest, Points deformed)
    : half_edges_(HalfEdges(triangles, static_cast<int>(rest.cols()))),
      triangles_(triangles),
      rest_(std::move(rest)),
      deformed_(std::move(deformed)) {
  assert(rest_.cols() == deformed_.cols());
  touch();
}

void MeshPair::set_deformed(Points deformed) {
  assert(deformed.cols() == rest_.cols());
  deformed_ = std::move(deformed);
}

void MeshPair::set_positions(Points rest, Points deformed) {
  assert(rest.cols() == rest_.cols() && deformed.cols() == rest_.cols());
  rest_ = std::move(rest);
  deformed_ = std::move(deformed);
}

void MeshPair::set_stiffness(std::shared_ptr<const Stiffness> stiffness) {
  stiffness_ = std::move(stiffness);
}

Edge MeshPair::edge(int e) const {
  const int a = half_edges_->from(2 * e), b = half_edges_->to(2 * e);
  return {std::min(a, b), std::max(a, b)};
}

std::optional<int> MeshPair::find_edge(int a, int b) const {
  const int h = half_edges_->find(a, b);
  if (h == HalfEdges::kNone) return std::nullopt;
  return h / 2;
}

std::array<int, 3> MeshPair::edges_of_triangle(int t) const {
  const int h = half_edges_->first(t);
  return {h / 2, half_edges_->next(h) / 2, half_edges_->previous(h) / 2};
}

bool MeshPair::is_boundary_edge(int e) const { return half_edges_->is_boundary_edge(e); }

bool MeshPair::is_boundary_vertex(int v) const {
  const int h = half_edges_->outgoing(v);
  return h == HalfEdges::kNone || half_edges_->is_boundary(h);
}

bool MeshPair::is_isolated(int v) const { return half_edges_->outgoing(v) == HalfEdges::kNone; }

Diamond MeshPair::diamond(int e) const {
  const int ab = 2 * e, ba = HalfEdges::opposite(ab);
  const auto apex = [this](int h) { return half_edges_->to(half_edges_->next(h)); };
  return {half_edges_->to(ba),       half_edges_->to(ab),      apex(ab), apex(ba),
          half_edges_->triangle(ab), half_edges_->triangle(ba)};
}

std::vector<int> MeshPair::triangles_of_edge(int e) const {
  std::vector<int> triangles;
  for (const int h : {2 * e, 2 * e + 1})
    if (!half_edges_->is_boundary(h)) triangles.push_back(half_edges_->triangle(h));
  return triangles;
}

std::vector<int> MeshPair::triangles_of_vertex(int v) const {
  std::vector<int> triangles;
  // The outgoing half-edge of a boundary vertex is its boundary half-edge, so the walk is complete.
  const int begin = half_edges_->outgoing(v);
  if (begin == HalfEdges::kNone) return triangles;
  int h = begin;
  do {
    if (!half_edges_->is_boundary(h)) triangles.push_back(half_edges_->triangle(h));
    h = HalfEdges::opposite(half_edges_->previous(h));
  } while (h != begin);
  return triangles;
}

bool MeshPair::is_flip_legal(int e) const { return half_edges_->may_flip(e); }

void MeshPair::flip(int e) {
  assert(is_flip_legal(e));
  half_edges_.own().flip(e);
  read_triangle(half_edges_->triangle(2 * e));
  read_triangle(half_edges_->triangle(2 * e + 1));
  touch();
}

int MeshPair::split_edge(int e, double t) {
  assert(0 < t && t < 1);
  const auto [a, b] = edge(e);
  const int v = vertex_count();
  append_vertex(rest_.col(a) + t * (rest_.col(b) - rest_.col(a)),
                deformed_.col(a) + t * (deformed_.col(b) - deformed_.col(a)));
  half_edges_.own().split_edge(e, v);
  read_triangles_round(v);
  return v;
}

int MeshPair::split_triangle(int t, const Eigen::Vector3d& barycentric) {
  const Eigen::Vector3i corners = triangles_.col(t);
  const auto at = [&](const Points& points) -> Vec2 {
    return points.col(corners[0]) * barycentric[0] + points.col(corners[1]) * barycentric[1] +
           points.col(corners[2]) * barycentric[2];
  };
  const int v = vertex_count();
  append_vertex(at(rest_), at(deformed_));
  half_edges_.own().split_triangle(t, v);
  read_triangles_round(v);
  return v;
}

void MeshPair::append_vertex(const Vec2& rest, const Vec2& deformed) {
  half_edges_.own().add_vertex();
  rest_.conservativeResize(Eigen::NoChange, rest_.cols() + 1);
  deformed_.conservativeResize(Eigen::NoChange, deformed_.cols() + 1);
  rest_.rightCols<1>() = rest;
  deformed_.rightCols<1>() = deformed;
}

void MeshPair::read_triangle(int t) {
  int h = half_edges_->first(t);
  for (int corner = 0; corner < 3; ++corner) {
    triangles_(corner, t) = half_edges_->to(h);
    h = half_edges_->next(h);
  }
}

void MeshPair::read_triangles_round(int v) {
  triangles_.conservativeResize(Eigen::NoChange, half_edges_->triangle_count());
  for (const int t : triangles_of_vertex(v)) read_triangle(t);
  touch();
}

void MeshPair::touch() { revision_ = next_revision(); }

}  // namespace foldless
