// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/document.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/energy/constraints.h"
#include "core/energy/densities.h"
#include "core/method/satisfied.h"
#include "core/run/active_part.h"
#include "core/run/followers.h"
#include "core/run/original_edges.h"

namespace foldless {
namespace {

template <class T>
bool is_equal(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
  return a == b || (a && b && a->cols() == b->cols() && *a == *b);
}

bool is_equal(const std::shared_ptr<const Shape>& a, const std::shared_ptr<const Shape>& b) {
  if (a == b) return true;
  return a && b && a->rest.cols() == b->rest.cols() && a->rest == b->rest &&
         a->triangles.cols() == b->triangles.cols() && a->triangles == b->triangles;
}

bool is_equal(const std::shared_ptr<const Snapshot>& a, const std::shared_ptr<const Snapshot>& b) {
  if (a == b) return true;
  return a && b && is_equal(a->triangles, b->triangles) && is_equal(a->rest, b->rest) &&
         a->deformed == b->deformed;
}

bool is_equal(const std::shared_ptr<const Stiffness>& a,
              const std::shared_ptr<const Stiffness>& b) {
  return a == b || (a && b && *a == *b);
}

bool is_equal(const std::shared_ptr<const Animation>& a,
              const std::shared_ptr<const Animation>& b) {
  return a == b || (a && b && *a == *b);
}

bool is_equal(const std::shared_ptr<const MeshParts>& a,
              const std::shared_ptr<const MeshParts>& b) {
  return a == b || (a && b && *a == *b);
}

}  // namespace

Document empty_document() {
  Document document;
  document.energy = find_density("arap");
  return document;
}

Document document_of(Shape shape, std::string name) {
  Document document = empty_document();
  const MeshPair mesh(shape.triangles, shape.rest);
  document.original = std::make_shared<const Shape>(std::move(shape));
  document.pose = pose_of(mesh, *document.original);
  document.name = std::move(name);
  return document;
}

MeshPair mesh_of(const Document& document) {
  const Snapshot& pose = *document.pose;
  MeshPair mesh(*pose.triangles, *pose.rest, pose.deformed);
  mesh.set_stiffness(stiffness_with(document.stiffness, document.handles, *pose.rest));
  return mesh;
}

Problem problem_of(const Document& document) {
  const auto& original = document.original;
  return {mesh_of(document), document.energy, document.handles, document.parameters,
          OriginalMesh{std::shared_ptr<const Triangles>(original, &original->triangles),
                       static_cast<int>(original->rest.cols())}};
}

std::shared_ptr<const Snapshot> pose_of(const MeshPair& mesh, const Shape& original) {
  const int vertices = static_cast<int>(original.rest.cols());
  const OriginalEdges edges(original.triangles, vertices);
  auto pose = std::make_shared<Snapshot>();
  pose->revision = mesh.revision();
  pose->triangles = std::make_shared<const Triangles>(mesh.triangles());
  pose->rest = std::make_shared<const Points>(mesh.rest());
  pose->deformed = mesh.deformed();
  pose->flipped_edges =
      std::make_shared<const std::vector<Edge>>(edges.flipped_in(mesh.triangles()));
  pose->original_vertices = vertices;
  return pose;
}

std::shared_ptr<const Snapshot> with_looks_of(const Document& document,
                                              std::shared_ptr<const Snapshot> pose) {
  std::vector<Handle> handles = pose->handles;
  for (Handle& handle : handles)
    if (const Handle* now = find_handle(document, handle.id)) {
      handle.depth = now->depth;
      handle.name = now->name;
    }
  if (handles == pose->handles) return pose;
  auto changed = std::make_shared<Snapshot>(*pose);
  changed->handles = std::move(handles);
  return changed;
}

const Handle* find_handle(const Document& document, int id) {
  const auto& handles = document.handles;
  const auto it = std::find_if(handles.begin(), handles.end(),
                               [id](const Handle& handle) { return handle.id == id; });
  return it == handles.end() ? nullptr : &*it;
}

const Handle* handle_at_vertex(const Document& document, int vertex) {
  const auto& handles = document.handles;
  const auto it = std::find_if(handles.begin(), handles.end(),
                               [vertex](const Handle& h) { return h.vertex == vertex; });
  return it == handles.end() ? nullptr : &*it;
}

Vec2 position_of(const Document& document, const Handle& handle) {
  return document.pose->deformed.col(handle.vertex);
}

double target_tolerance(const Document& document) {
  if (document.is_empty()) return 0;
  return std::sqrt(kSatisfied) *
         active_diagonal(*document.pose->triangles, *document.pose->rest, document.handles);
}

bool is_at_targets(const Document& document) {
  if (document.handles.empty()) return true;
  const Points& rest = *document.pose->rest;
  const Followers followers(document.original->triangles, rest, document.handles);
  const double error = handle_error_squared(
      constraints_of(followers.with_followers(document.handles)), document.pose->deformed);
  if (error == 0) return true;  // without a look at the mesh
  const double tolerance = target_tolerance(document);
  return error <= tolerance * tolerance;
}

bool is_same_content(const Document& a, const Document& b) {
  return is_equal(a.original, b.original) && is_equal(a.pose, b.pose) && a.handles == b.handles &&
         a.rig == b.rig && is_equal(a.animation, b.animation) &&
         is_equal(a.stiffness, b.stiffness) && a.energy == b.energy &&
         a.parameters == b.parameters && a.texture == b.texture && a.texture_box == b.texture_box &&
         is_equal(a.parts, b.parts);
}

}  // namespace foldless
