// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_markers.h"

#include <algorithm>
#include <numbers>

namespace foldless {
namespace {

constexpr int kShadowSteps = 6;

glm::dvec2 place_in(const VectorPane& pane, const MarkerScene& scene, glm::vec2 local_point) {
  const glm::dvec2 world = scene.local.origin + scene.local.unit * glm::dvec2(local_point);
  return world_to_pixel(scene.view.camera, pane.size, world);
}

/// Adds the outline of a marker moved outwards by so many pixels: a square with round corners, or a
/// disc.
void add_marker(const VectorPane& pane, glm::dvec2 centre, const Marker& marker, double outwards) {
  constexpr double kQuarter = std::numbers::pi / 2;
  const double radius = std::max(marker.radius + outwards, 0.0);
  const double corner = std::clamp(marker.radius * marker.roundness + outwards, 0.0, radius);
  const double to_corner = radius - corner;
  cairo_new_sub_path(pane.cairo);
  cairo_arc(pane.cairo, centre.x + to_corner, centre.y + to_corner, corner, 0, kQuarter);
  cairo_arc(pane.cairo, centre.x - to_corner, centre.y + to_corner, corner, kQuarter, 2 * kQuarter);
  cairo_arc(pane.cairo, centre.x - to_corner, centre.y - to_corner, corner, 2 * kQuarter,
            3 * kQuarter);
  cairo_arc(pane.cairo, centre.x + to_corner, centre.y - to_corner, corner, 3 * kQuarter,
            4 * kQuarter);
  cairo_close_path(pane.cairo);
}

/// Opacity of a shadow so many design pixels outside of the marker, as in the shader of markers.
double shadow_at(double outwards, double opacity) {
  const double t = std::clamp((outwards + 1) / 4.5, 0.0, 1.0);
  return opacity * (1 - t * t * (3 - 2 * t));
}

/// Layers over each other, from the largest to the smallest, come to the opacity of the shadow.
void draw_shadow(const VectorPane& pane, glm::dvec2 centre, const Marker& marker) {
  cairo_set_fill_rule(pane.cairo, CAIRO_FILL_RULE_EVEN_ODD);
  double before = 0;
  for (int step = kShadowSteps - 1; step >= 0; --step) {
    const double outwards = -1 + 4.5 * (step + 0.5) / kShadowSteps;
    const double opacity = shadow_at(outwards, marker.shadow);
    add_marker(pane, centre + glm::dvec2(0, pane.ui_scale), marker, outwards * pane.ui_scale);
    if (marker.fill.a == 0) add_marker(pane, centre, marker, -marker.rim_width);  // the hole
    cairo_set_source_rgba(pane.cairo, 0, 0, 0, 1 - (1 - opacity) / (1 - before));
    cairo_fill(pane.cairo);
    before = opacity;
  }
  cairo_set_fill_rule(pane.cairo, CAIRO_FILL_RULE_WINDING);
}

}  // namespace

void draw_markers(const VectorPane& pane, const MarkerScene& scene,
                  const std::vector<Marker>& markers) {
  cairo_set_dash(pane.cairo, nullptr, 0, 0);
  for (const Marker& marker : markers) {
    const glm::dvec2 centre = place_in(pane, scene, marker.centre);
    if (!may_meet({centre}, seen_box(pane))) continue;
    if (marker.shadow > 0) draw_shadow(pane, centre, marker);
    add_marker(pane, centre, marker, -0.5 * marker.rim_width);
    if (marker.fill.a > 0) {
      set_colour(pane, marker.fill);
      cairo_fill_preserve(pane.cairo);
    }
    cairo_set_line_width(pane.cairo, marker.rim_width);
    set_colour(pane, marker.rim);
    cairo_stroke(pane.cairo);
  }
}

void draw_handles(const VectorPane& pane, const MarkerScene& scene) {
  const HandleMarkers markers = handle_markers(scene);
  for (std::size_t i = 0; i + 1 < markers.line_ends.size(); i += 2)
    add_line(pane, place_in(pane, scene, markers.line_ends[i]),
             place_in(pane, scene, markers.line_ends[i + 1]));
  set_line(pane, markers.line_style);
  cairo_stroke(pane.cairo);
  draw_markers(pane, scene, markers.targets);
  draw_markers(pane, scene, markers.handles);
}

}  // namespace foldless
