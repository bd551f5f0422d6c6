// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/active_part.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/mesh/components.h"
#include "core/method/satisfied.h"

namespace foldless {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// By vertex: whether it is in a component with a handle, and in a triangle.
std::vector<bool> active_vertices(const Triangles& triangles, int vertices,
                                  const std::vector<Handle>& handles) {
  const std::vector<int> component = components_of(triangles, vertices);
  std::vector<bool> has_handle(at(vertices), false);
  for (const Handle& handle : handles) has_handle[at(component[at(handle.vertex)])] = true;
  std::vector<bool> is_active(at(vertices), false);
  for (const int v : triangles.reshaped()) is_active[at(v)] = has_handle[at(component[at(v)])];
  return is_active;
}

/// D of those that are active, or of all that are in a triangle where none is.
double diagonal_of(const Triangles& triangles, const Points& rest, std::vector<bool> is_active) {
  if (std::ranges::none_of(is_active, std::identity()))
    for (const int v : triangles.reshaped()) is_active[at(v)] = true;
  std::vector<int> vertices;
  for (int v = 0; v < static_cast<int>(rest.cols()); ++v)
    if (is_active[at(v)]) vertices.push_back(v);
  return bounding_box_diagonal(rest(Eigen::all, vertices));
}

/// Where elements are in the whole.
struct Places {
  std::vector<int> of_part;
  std::vector<int> of_idle;    ///< now
  std::vector<int> idle_then;  ///< when the part was made
  int count() const { return static_cast<int>(of_part.size() + of_idle.size()); }
};

/// Where they are when the part has so many.
Places places(const std::vector<bool>& is_active, int part_count) {
  Places places;
  int next = 0;
  for (std::size_t i = 0; i < is_active.size(); ++i) {
    if (!is_active[i]) {
      places.of_idle.push_back(next++);
      places.idle_then.push_back(static_cast<int>(i));
    } else if (static_cast<int>(places.of_part.size()) < part_count) {
      places.of_part.push_back(next++);
    }
  }
  while (static_cast<int>(places.of_part.size()) < part_count) places.of_part.push_back(next++);
  return places;
}

/// `part`: the index in the part of every vertex, −1 for those that are idle.
OriginalMesh original_of_part(const OriginalMesh& original, const std::vector<int>& part) {
  const auto index = [&part](int v) { return part[at(v)]; };
  Triangles triangles(3, original.triangles->cols());
  Eigen::Index count = 0;
  for (const auto& t : original.triangles->colwise())
    if (index(t[0]) >= 0) triangles.col(count++) = t.unaryExpr(index);
  const auto vertices = static_cast<int>(
      std::count_if(part.begin(), part.begin() + original.vertices, [](int v) { return v >= 0; }));
  return {std::make_shared<const Triangles>(triangles.leftCols(count)), vertices};
}

}  // namespace

ActivePart::ActivePart(const MeshPair& whole, const std::vector<Handle>& handles)
    : is_active_vertex_(active_vertices(whole.triangles(), whole.vertex_count(), handles)),
      is_whole_(std::ranges::all_of(is_active_vertex_, std::identity())),
      diagonal_(is_whole_ ? bounding_box_diagonal(whole.rest())
                          : diagonal_of(whole.triangles(), whole.rest(), is_active_vertex_)),
      faces_of_part_(whole.face_count()) {
  if (is_whole_) return;
  triangles_ = whole.triangles();
  rest_ = whole.rest();
  deformed_ = whole.deformed();
  for (const auto& t : triangles_.colwise()) is_active_face_.push_back(is_active_vertex_[at(t[0])]);
  faces_of_part_ = static_cast<int>(std::ranges::count(is_active_face_, true));
}

Problem ActivePart::of(const Problem& problem) const {
  if (is_whole()) return problem;
  std::vector<int> whole, part(is_active_vertex_.size(), -1);
  for (std::size_t v = 0; v < is_active_vertex_.size(); ++v) {
    if (!is_active_vertex_[v]) continue;
    part[v] = static_cast<int>(whole.size());
    whole.push_back(static_cast<int>(v));
  }
  Triangles triangles(3, faces_of_part_);
  Eigen::Index next = 0;
  for (Eigen::Index f = 0; f < triangles_.cols(); ++f)
    if (is_active_face_[static_cast<std::size_t>(f)])
      triangles.col(next++) = triangles_.col(f).unaryExpr([&](int v) { return part[at(v)]; });

  Problem cut{{}, problem.energy, problem.handles, problem.parameters, problem.original};
  cut.mesh = MeshPair(triangles, problem.mesh.rest()(Eigen::all, whole),
                      problem.mesh.deformed()(Eigen::all, whole));
  cut.mesh.set_stiffness(problem.mesh.stiffness());
  for (Handle& handle : cut.handles) handle.vertex = part[at(handle.vertex)];
  if (cut.original) cut.original = original_of_part(*problem.original, part);
  return cut;
}

Triangles ActivePart::whole_triangles(const Triangles& part, int part_vertices) const {
  if (is_whole()) return part;
  const Places vertices = places(is_active_vertex_, part_vertices);
  const Places faces = places(is_active_face_, static_cast<int>(part.cols()));
  std::vector<int> idle_vertex(is_active_vertex_.size(), -1);
  for (std::size_t i = 0; i < vertices.of_idle.size(); ++i)
    idle_vertex[at(vertices.idle_then[i])] = vertices.of_idle[i];

  Triangles whole(3, faces.count());
  for (Eigen::Index f = 0; f < part.cols(); ++f)
    whole.col(faces.of_part[static_cast<std::size_t>(f)]) =
        part.col(f).unaryExpr([&](int v) { return vertices.of_part[at(v)]; });
  for (std::size_t i = 0; i < faces.of_idle.size(); ++i)
    whole.col(faces.of_idle[i]) =
        triangles_.col(faces.idle_then[i]).unaryExpr([&](int v) { return idle_vertex[at(v)]; });
  return whole;
}

Points ActivePart::whole_points(Points part, const Points& then) const {
  if (is_whole()) return part;  // after every step
  const Places vertices = places(is_active_vertex_, static_cast<int>(part.cols()));
  Points whole(2, vertices.count());
  whole(Eigen::all, vertices.of_part) = part;
  whole(Eigen::all, vertices.of_idle) = then(Eigen::all, vertices.idle_then);
  return whole;
}

double active_diagonal(const Triangles& triangles, const Points& rest,
                       const std::vector<Handle>& handles) {
  return diagonal_of(triangles, rest,
                     active_vertices(triangles, static_cast<int>(rest.cols()), handles));
}

}  // namespace foldless
