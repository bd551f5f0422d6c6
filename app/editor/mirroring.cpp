// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/mirroring.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/editor/bones.h"
#include "app/editor/editor.h"
#include "app/editor/handle_edits.h"
#include "core/rig/symmetry.h"

namespace foldless {
namespace {

constexpr double kPartOfDrawing = 0.02;

Vec2 place_at_rest(const Document& document, const Handle& handle) {
  return document.pose->rest->col(handle.vertex);
}

void set_axis(Editor& editor, const char* label, const MirrorAxis& axis) {
  Document document = editor.document();
  document.rig.mirror = Mirror{axis, true};
  if (document.rig == editor.document().rig) return;
  editor.draft().edit(label, std::move(document), Change::appearance);
}

MirrorAxis found_axis(const Document& document) {
  return symmetry_axis(document.original->triangles, document.original->rest);
}

void set_axis_through_middle(Editor& editor, const char* label, const Vec2& direction) {
  editor.draft().interrupt();
  if (editor.document().is_empty()) return;
  const Shape& shape = *editor.document().original;
  set_axis(editor, label, axis_through_middle(shape.triangles, shape.rest, direction));
}

bool is_moved(const std::vector<Target>& moved, int id) {
  return std::ranges::find(moved, id, &Target::id) != moved.end();
}

std::vector<Target> with_partners(const Document& before, std::vector<Target> moved, double reach) {
  const MirrorAxis& axis = before.rig.mirror->axis;
  const std::size_t count = moved.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Target target = moved[i];
    const Handle* handle = find_handle(before, target.id);
    const auto partner = handle ? partner_of(before, *handle, reach) : std::nullopt;
    if (!partner || is_moved(moved, *partner)) continue;
    const Handle& other = *find_handle(before, *partner);
    Target follows{other.id, other.target + mirrored_way(axis, target.position - handle->target)};
    if (other.turn && handle->turn && target.angle)
      follows.angle = other.turn->angle - (*target.angle - handle->turn->angle);
    moved.push_back(follows);
  }
  return moved;
}

/// The nearest corner of a triangle at rest within a distance.
std::optional<int> corner_near(const Document& document, int triangle, const Vec2& point,
                               double reach) {
  std::optional<int> nearest;
  for (const int v : document.pose->triangles->col(triangle)) {
    const double distance = (document.pose->rest->col(v) - point).norm();
    if (distance > reach) continue;
    reach = distance;
    nearest = v;
  }
  return nearest;
}

MeshHit hit_at_rest(const Document& document, int triangle, const Vec2& p, double reach) {
  MeshHit hit;
  hit.vertex = corner_near(document, triangle, p, reach);
  hit.triangle = triangle;
  const Points& rest = *document.pose->rest;
  const Eigen::Vector3i t = document.pose->triangles->col(triangle);
  const Vec2 a = rest.col(t[0]), b = rest.col(t[1]), c = rest.col(t[2]);
  hit.barycentric =
      Eigen::Vector3d(signed_area(p, b, c), signed_area(a, p, c), signed_area(a, b, p)) /
      signed_area(a, b, c);
  return hit;
}

std::string words_on_alone(const std::vector<std::string>& alone) {
  std::string words =
      alone.size() == 1 ? "No partner in the mirror: " : "No partners in the mirror: ";
  for (const std::string& name : alone) {
    if (&name != &alone.front()) words += ", ";
    words += name;
  }
  return words;
}

}  // namespace

std::optional<int> partner_of(const Document& document, const Handle& handle, double reach) {
  if (!document.rig.mirror) return std::nullopt;
  const Vec2 image = mirrored(document.rig.mirror->axis, place_at_rest(document, handle));
  std::optional<int> nearest;
  for (const Handle& other : document.handles) {
    const double distance = (place_at_rest(document, other) - image).norm();
    if (distance > reach) continue;
    reach = distance;
    nearest = other.id;
  }
  return nearest;
}

double partner_reach(const Editor& editor) {
  const Canvas& canvas = editor.canvas();
  const double hit = canvas.hit_radius() / canvas.camera.pixels_per_unit;
  if (editor.document().is_empty()) return hit;
  const Points& rest = editor.document().original->rest;
  const double diagonal = (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm();
  return std::max(hit, kPartOfDrawing * diagonal);
}

std::vector<Target> with_rig(const Editor& editor, const Document& before,
                             std::vector<Target> moved) {
  moved = with_bones(before, std::move(moved));
  if (!is_mirror_on(editor)) return moved;
  return with_partners(before, std::move(moved), partner_reach(editor));
}

MirrorImage with_mirror_image(const Editor& editor, Document document, int id) {
  const double reach = partner_reach(editor);
  const Handle& handle = *find_handle(document, id);
  if (!is_mirror_on(editor) || partner_of(document, handle, reach)) return {std::move(document)};
  const Vec2 image = mirrored(document.rig.mirror->axis, place_at_rest(document, handle));
  const auto triangle = triangle_at(*document.pose->triangles, *document.pose->rest, image);
  if (!triangle) return {std::move(document), true};
  return {place_handle(document, hit_at_rest(document, *triangle, image, reach)).document};
}

bool is_mirror_on(const Editor& editor) {
  const auto& mirror = editor.document().rig.mirror;
  return mirror && mirror->is_on;
}

void toggle_mirror(Editor& editor) {
  editor.draft().interrupt();
  if (editor.document().is_empty()) return;
  Document document = editor.document();
  if (document.rig.mirror)
    document.rig.mirror->is_on = !document.rig.mirror->is_on;
  else
    document.rig.mirror = Mirror{found_axis(document), true};
  const char* label = document.rig.mirror->is_on ? "Mirror on" : "Mirror off";
  editor.draft().edit(label, std::move(document), Change::appearance);
}

void find_mirror_axis(Editor& editor) {
  editor.draft().interrupt();
  if (!editor.document().is_empty())
    set_axis(editor, "Find the mirror axis", found_axis(editor.document()));
}

void set_upright_mirror(Editor& editor) {
  set_axis_through_middle(editor, "Upright mirror axis", Vec2::UnitY());
}

void set_level_mirror(Editor& editor) {
  set_axis_through_middle(editor, "Level mirror axis", Vec2::UnitX());
}

void pose_mirrored(Editor& editor) {
  editor.draft().interrupt();
  if (editor.selection().ids().empty()) return;
  editor.playback().use_iteration();  // what is looked at is what is mirrored
  Document document = editor.document();
  if (!document.rig.mirror) document.rig.mirror = Mirror{found_axis(document), false};
  std::vector<Target> targets;
  std::vector<std::string> alone;
  for (const Handle& handle : document.handles) {
    if (!editor.selection().ids().contains(handle.id)) continue;
    const auto partner = partner_of(document, handle, partner_reach(editor));
    if (!partner) {
      alone.push_back(handle.name.empty() ? "vertex " + std::to_string(handle.vertex)
                                          : handle.name);
      continue;
    }
    const Handle& other = *find_handle(document, *partner);
    const Vec2 way = other.target - place_at_rest(document, other);
    Target target{handle.id,
                  place_at_rest(document, handle) + mirrored_way(document.rig.mirror->axis, way)};
    if (handle.turn && other.turn) target.angle = -other.turn->angle;
    targets.push_back(target);
  }
  if (!alone.empty()) editor.messages().toast(ToastKind::notice, words_on_alone(alone));
  Document posed = with_targets(document, with_bones(document, std::move(targets)));
  if (posed.handles == document.handles) return;
  editor.draft().solving().clear_timeline();
  editor.draft().edit("Pose mirrored", std::move(posed), Change::targets);
}

}  // namespace foldless
