// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/vector_pane.h"

#include <algorithm>
#include <utility>

namespace foldless {
namespace {

constexpr double kBeyond = 100;  // pixels; wider than any line or marker

double doubled_area(const Polygon& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

}  // namespace

Box seen_box(const VectorPane& pane) {
  const glm::dvec2 beyond(kBeyond * pane.ui_scale);
  return {-beyond, pane.size + beyond};
}

void set_colour(const VectorPane& pane, const glm::vec4& colour) {
  cairo_set_source_rgba(pane.cairo, colour.r, colour.g, colour.b, colour.a);
}

void add_polygon(const VectorPane& pane, Polygon polygon) {
  const Box box = seen_box(pane);
  if (!may_meet(polygon, box)) return;
  const auto is_far = [&box](glm::dvec2 p) {
    return p.x < box.min.x || p.y < box.min.y || p.x > box.max.x || p.y > box.max.y;
  };
  if (std::ranges::any_of(polygon, is_far)) polygon = clipped(std::move(polygon), box);
  if (polygon.size() < 3) return;
  if (doubled_area(polygon) < 0) std::ranges::reverse(polygon);
  cairo_move_to(pane.cairo, polygon[0].x, polygon[0].y);
  for (std::size_t i = 1; i < polygon.size(); ++i)
    cairo_line_to(pane.cairo, polygon[i].x, polygon[i].y);
  cairo_close_path(pane.cairo);
}

void add_line(const VectorPane& pane, glm::dvec2 a, glm::dvec2 b) {
  const auto seen = clipped_line(a, b, seen_box(pane));
  if (!seen) return;
  cairo_move_to(pane.cairo, seen->first.x, seen->first.y);
  cairo_line_to(pane.cairo, seen->second.x, seen->second.y);
}

void set_line(const VectorPane& pane, const LineStyle& style, double share) {
  glm::vec4 colour = style.colour;
  colour.a *= static_cast<float>(share);
  set_colour(pane, colour);
  cairo_set_line_width(pane.cairo, style.width * pane.ui_scale);
  cairo_set_line_cap(pane.cairo, style.has_round_ends ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  const double dash = style.dash * pane.ui_scale;
  // A line begins in the middle of a gap.
  cairo_set_dash(pane.cairo, &dash, dash > 0 ? 1 : 0, 1.5 * dash);
}

}  // namespace foldless
