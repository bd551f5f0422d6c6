// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/turning.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/handle_edits.h"

namespace foldless {
namespace {

constexpr double kDegreesOfARadian = 180 / std::numbers::pi;
constexpr double kRingRadius = 26, kRingWidth = 5;  // design pixels
constexpr double kReachOfDiagonal = 0.05, kReachOfEdge = 1.05;

bool has_corner(const Triangles& triangles, Eigen::Index t, int vertex) {
  return (triangles.col(t).array() == vertex).any();
}

/// How far the mesh is turned round a vertex, and how far a Turn has to reach to hold it: the
/// rotation that is nearest to the map of the triangles there, and their longest edge.
Turn turn_at(const Document& document, int vertex) {
  const Snapshot& pose = *document.pose;
  Mat2 map = Mat2::Zero();
  double longest = 0;
  for (Eigen::Index t = 0; t < pose.triangles->cols(); ++t) {
    if (!has_corner(*pose.triangles, t, vertex)) continue;
    const Eigen::Vector3i corners = pose.triangles->col(t);
    const Vec2 a = pose.rest->col(corners[0]), b = pose.rest->col(corners[1]),
               c = pose.rest->col(corners[2]);
    map += signed_area(a, b, c) * deformation_gradient(*pose.rest, pose.deformed, corners);
    for (const int v : corners)
      longest = std::max(longest, (pose.rest->col(v) - pose.rest->col(vertex)).norm());
  }
  const double angle = std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1)) * kDegreesOfARadian;
  const Points& rest = document.original->rest;
  const double diagonal = (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm();
  return {angle, std::max(kReachOfDiagonal * diagonal, kReachOfEdge * longest)};
}

Document with_turns(Document document, const std::set<int>& ids) {
  for (Handle& handle : document.handles)
    if (ids.contains(handle.id) && !handle.turn) handle.turn = turn_at(document, handle.vertex);
  return document;
}

/// Begins an edit in which a handle that is alone has a Turn.
std::vector<Target> begin_turning(Editor& editor) {
  editor.draft().begin_edit();
  editor.draft().solving().clear_timeline();
  const std::set<int>& ids = editor.selection().ids();
  if (ids.size() == 1) {
    Document turning = with_turns(editor.document(), ids);
    if (turning.handles != editor.document().handles)
      editor.draft().apply(std::move(turning), Change::mesh);
  }
  return selected_targets(editor);
}

}  // namespace

bool HandleRing::is_near(const Vec2& pixel, const Canvas& canvas) const {
  return std::abs((pixel - centre).norm() - radius) <= kRingWidth * canvas.ui_scale;
}

std::optional<HandleRing> handle_ring(const Editor& editor) {
  const std::set<int>& ids = editor.selection().ids();
  if (ids.size() != 1 || !editor.shown() || !editor.view().shown_options().layers.handles)
    return std::nullopt;
  for (const Handle& handle : editor.shown()->handles) {
    if (handle.id != *ids.begin()) continue;
    const Canvas& canvas = editor.canvas();
    HandleRing ring{canvas.to_pixel(handle.target), kRingRadius * canvas.ui_scale, 0, std::nullopt};
    if (handle.turn) {
      ring.angle = handle.turn->angle;
      ring.reach = handle.turn->radius * canvas.camera.pixels_per_unit;
    }
    return ring;
  }
  return std::nullopt;
}

void set_turning(Editor& editor, bool turns) {
  const Document turning = with_turns(editor.document(), editor.selection().ids());
  editor.edits().change_selected(turns ? "Turn with handle" : "Turn freely", Change::mesh,
                                 [&](Handle& handle) {
                                   handle.turn.reset();
                                   if (turns) handle.turn = find_handle(turning, handle.id)->turn;
                                 });
}

void set_angle(Editor& editor, double degrees) {
  if (!std::isfinite(degrees)) return;
  editor.edits().change_selected("Turn", Change::targets, [degrees](Handle& handle) {
    if (handle.turn) handle.turn->angle = degrees;
  });
}

void set_radius(Editor& editor, double radius) {
  if (!std::isfinite(radius) || radius <= 0) return;
  editor.edits().change_selected("Radius", Change::mesh, [radius](Handle& handle) {
    if (handle.turn) handle.turn->radius = radius;
  });
}

void begin_transformation(Editor& editor, Transformation what) {
  editor.draft().interrupt();
  const std::size_t count = editor.selection().ids().size();
  if (count == 0 || (count == 1 && what == Transformation::scale)) return;
  editor.input().begin(make_transform_tool(what, editor.input().pointer(), begin_turning(editor)));
}

std::unique_ptr<Tool> begin_ring(Editor& editor, const Vec2& from) {
  return make_ring_tool(from, begin_turning(editor));
}

}  // namespace foldless
