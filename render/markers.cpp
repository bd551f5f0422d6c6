// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/markers.h"

#include <algorithm>

#include "render/theme.h"

namespace foldless {
namespace {

constexpr float kHandleRadius = 7;  // design pixels, here and below
constexpr float kTargetRadius = 7.5F;
constexpr float kSplitRadius = 3.6F;
constexpr double kReached = 0.75;  // a target nearer than this has no ghost
constexpr glm::vec4 kNothing{0, 0, 0, 0};

glm::vec2 local(const MarkerScene& scene, const Vec2& point) {
  return scene.local.to_local({point.x(), point.y()});
}

const Points& points_of(const MarkerScene& scene) {
  return scene.options.pose == Pose::rest ? *scene.snapshot.rest : scene.snapshot.deformed;
}

bool has_vertex(const Handle& handle, const Points& points) {
  return handle.vertex >= 0 && handle.vertex < points.cols();
}

bool is_selected(const Handle& handle, const SceneView& view) {
  return std::find(view.selected.begin(), view.selected.end(), handle.id) != view.selected.end();
}

/// Rings are wider than discs, so that their hole shows, and grow with the weight.
float radius_of(const Handle& handle) {
  if (handle.kind != HandleKind::soft) return kHandleRadius;
  const auto weight = static_cast<float>(std::max(handle.weight, 0.0));
  return kHandleRadius + 2 + 7 * weight / (1 + weight);
}

/// A ring of `reach` pixels round a marker, which leaves it the shadow.
void add_halo(std::vector<Marker>& markers, Marker& body, const glm::vec4& colour, float reach) {
  Marker halo = body;
  halo.radius += reach;
  halo.rim = colour;
  halo.rim_width = reach + 0.5F * body.rim_width;  // reaches under the rim, but not into a ring
  halo.fill = kNothing;
  markers.push_back(halo);
  body.shadow = 0;
}

/// The ring of a soft handle, its light outline inside and outside.
void add_ring(std::vector<Marker>& markers, Marker body, const glm::vec4& colour, float scale) {
  const float outline = body.rim_width;
  body.fill = kNothing;
  body.rim_width = 3 * scale + 2 * outline;
  markers.push_back(body);
  body.radius -= outline;
  body.rim_width = 3 * scale;
  body.rim = colour;
  body.shadow = 0;
  markers.push_back(body);
}

void add_handle(std::vector<Marker>& markers, const Handle& handle, const MarkerScene& scene) {
  const CanvasColours& colours = canvas_colours(scene.options.theme);
  const auto scale = static_cast<float>(scene.options.ui_scale);
  const bool selected = is_selected(handle, scene.view);
  Marker body{.centre = local(scene, points_of(scene).col(handle.vertex)),
              .radius = radius_of(handle) * scale,
              .roundness = handle.kind == HandleKind::pin ? 0.22F : 1.0F,
              .rim_width = 1.75F * scale,
              .shadow = 0.4F,
              .fill = colours.handle,
              .rim = colours.handle_rim};
  if (handle.kind == HandleKind::pin) body.radius *= 0.9F;
  if (scene.view.hovered == handle.id) add_halo(markers, body, colours.hovered, 4.5F * scale);
  if (selected) add_halo(markers, body, colours.selected, 2.5F * scale);
  if (handle.kind == HandleKind::soft) {
    add_ring(markers, body, colours.handle, scale);
  } else {
    markers.push_back(body);
  }
}

/// A hollow ring between two thin outlines, visible on any fill.
void add_target(std::vector<Marker>& markers, const glm::vec2& centre, const MarkerScene& scene) {
  const CanvasColours& colours = canvas_colours(scene.options.theme);
  const auto scale = static_cast<float>(scene.options.ui_scale);
  Marker ring{.centre = centre,
              .radius = (kTargetRadius + 1) * scale,
              .roundness = 1,
              .rim_width = 4.25F * scale,
              .shadow = 0.25F,
              .fill = kNothing,
              .rim = colours.handle_rim};
  markers.push_back(ring);
  ring.radius -= scale;
  ring.rim_width = 2.25F * scale;
  ring.shadow = 0;
  ring.rim = colours.target;
  markers.push_back(ring);
}

}  // namespace

std::vector<Marker> split_markers(const MarkerScene& scene, const std::vector<int>& vertices) {
  const CanvasColours& colours = canvas_colours(scene.options.theme);
  const auto scale = static_cast<float>(scene.options.ui_scale);
  const Points& points = points_of(scene);
  std::vector<Marker> markers;
  for (const int v : vertices)
    if (v >= scene.snapshot.original_vertices)
      markers.push_back({.centre = local(scene, points.col(v)),
                         .radius = kSplitRadius * scale,
                         .roundness = 1,
                         .rim_width = scale,
                         .shadow = 0,
                         .fill = colours.split,
                         .rim = colours.boundary});
  return markers;
}

HandleMarkers handle_markers(const MarkerScene& scene) {
  const Points& points = points_of(scene);
  const double pixels_per_unit = scene.view.camera.pixels_per_unit;
  const double scale = scene.options.ui_scale;
  HandleMarkers markers;
  markers.line_style = {
      .colour = canvas_colours(scene.options.theme).target, .width = 1.75F, .dash = 5};
  for (const Handle& handle : scene.snapshot.handles) {
    if (!has_vertex(handle, points)) continue;
    add_handle(markers.handles, handle, scene);
    const Vec2 way = points.col(handle.vertex) - handle.target;
    const double pixels = way.norm() * pixels_per_unit;
    if (pixels < kReached * scale) continue;
    add_target(markers.targets, local(scene, handle.target), scene);
    if (pixels < kTargetRadius * scale) continue;
    // The line ends at the ring, whose inside stays free.
    const Vec2 end = handle.target + way * (kTargetRadius * scale / pixels);
    markers.line_ends.push_back(local(scene, end));
    markers.line_ends.push_back(local(scene, points.col(handle.vertex)));
  }
  return markers;
}

}  // namespace foldless
