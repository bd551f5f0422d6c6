// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/edits.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "app/editor/bones.h"
#include "core/remesh/insert_vertex.h"
#include "core/run/mesh_at_rest.h"

namespace foldless {
namespace {

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
  auto [mesh, handles] = mesh_at_rest(*document.original, document.handles, *document.pose->rest,
                                      document.parameters.delta);
  for (Handle& handle : handles) {
    handle.target = mesh.deformed().col(handle.vertex);
    if (handle.turn) handle.turn->angle = 0;
  }
  at_rest.handles = std::move(handles);
  drop_what_has_no_handle(at_rest);
  at_rest.pose = pose_of(mesh, *document.original);
  return at_rest;
}

}  // namespace foldless
