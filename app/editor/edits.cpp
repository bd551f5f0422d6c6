// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/edits.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/editor/bones.h"
#include "app/editor/insert_vertex.h"

namespace foldless {
namespace {

/// Barycentric coordinates of a rest position in a rest triangle.
Eigen::Vector3d rest_barycentric(const MeshPair& mesh, int triangle, const Vec2& p) {
  const Eigen::Vector3i t = mesh.triangles().col(triangle);
  const Vec2 a = mesh.rest().col(t[0]), b = mesh.rest().col(t[1]), c = mesh.rest().col(t[2]);
  return Eigen::Vector3d(signed_area(p, b, c), signed_area(a, p, c), signed_area(a, b, p)) /
         signed_area(a, b, c);
}

/// The vertex of an undeformed mesh at a rest position, made if it has to be. Splits leave rest
/// positions inside their old triangle up to rounding, so the triangle in which the smallest
/// coordinate is largest holds the point.
int vertex_at_rest(MeshPair& mesh, const Vec2& p, double delta) {
  int best = 0;
  Eigen::Vector3d best_coordinates = Eigen::Vector3d::Constant(-1);
  for (int t = 0; t < mesh.face_count(); ++t) {
    const Eigen::Vector3d coordinates = rest_barycentric(mesh, t, p);
    if (t > 0 && coordinates.minCoeff() <= best_coordinates.minCoeff()) continue;
    best = t;
    best_coordinates = coordinates;
  }
  best_coordinates = best_coordinates.cwiseMax(0.0);
  return insert_vertex(mesh, best, best_coordinates / best_coordinates.sum(), delta);
}

/// Bones and tracks are those of the handles that are there.
void drop_what_has_no_handle(Document& document) {
  document.rig.bones = bones_of(std::move(document.rig.bones), document.handles);
  if (document.animation)
    document.animation =
        std::make_shared<const Animation>(animation_of(*document.animation, document.handles));
}

}  // namespace

Placed place_handle(const Document& document, const MeshHit& hit) {
  Placed placed{document, 0, true};
  int vertex = hit.vertex.value_or(-1);
  if (!hit.vertex) {
    MeshPair mesh = mesh_of(document);
    vertex = insert_vertex(mesh, hit.triangle, hit.barycentric, document.parameters.delta);
    if (mesh.vertex_count() > document.pose->deformed.cols())
      placed.document.pose = pose_of(mesh, *document.original);
  }
  if (const Handle* present = handle_at_vertex(document, vertex)) {
    placed.id = present->id;
    placed.is_new = false;
    return placed;
  }
  placed.id = document.next_handle_id;
  ++placed.document.next_handle_id;
  Handle handle;
  handle.id = placed.id;
  handle.vertex = vertex;
  handle.target = placed.document.pose->deformed.col(vertex);
  placed.document.handles.push_back(handle);
  return placed;
}

Document with_targets(Document document, const std::vector<Target>& targets) {
  for (const Target& target : targets)
    for (Handle& handle : document.handles)
      if (handle.id == target.id) {
        handle.target = target.position;
        if (handle.turn && target.angle) handle.turn->angle = *target.angle;
      }
  return document;
}

Document without_handles(Document document, const std::set<int>& ids) {
  std::erase_if(document.handles, [&](const Handle& h) { return ids.contains(h.id); });
  drop_what_has_no_handle(document);
  return document;
}

Document in_rest_pose(const Document& document) {
  Document at_rest = document;
  at_rest.handles.clear();
  const Shape& original = *document.original;
  MeshPair mesh(original.triangles, original.rest);
  for (Handle handle : document.handles) {
    if (handle.vertex >= original.rest.cols())
      handle.vertex =
          vertex_at_rest(mesh, document.pose->rest->col(handle.vertex), document.parameters.delta);
    handle.target = mesh.deformed().col(handle.vertex);
    if (handle.turn) handle.turn->angle = 0;
    if (!handle_at_vertex(at_rest, handle.vertex)) at_rest.handles.push_back(handle);
  }
  drop_what_has_no_handle(at_rest);
  at_rest.pose = pose_of(mesh, original);
  return at_rest;
}

}  // namespace foldless
