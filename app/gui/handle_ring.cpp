// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "app/editor/turning.h"
#include "app/gui/canvas_brush.h"

namespace foldless {
namespace {

struct Circle {
  ImVec2 centre;
  float radius = 0;
  float width = 0;  ///< of its line [design pixels]
};

/// Light on dark can be seen on every colour.
void draw_circle(const Circle& circle, const CanvasBrush& brush, const Look& look) {
  const auto& [centre, radius, width] = circle;
  brush.list.AddCircle(centre, radius, IM_COL32(0, 0, 0, 150), 0, look.px(width + 1.6F));
  brush.list.AddCircle(centre, radius, IM_COL32_WHITE, 0, look.px(width));
}

/// The ring, thicker under the pointer, with a knob at the angle; what turns lies inside of a thin
/// circle.
void draw_ring(const HandleRing& ring, bool is_near, const CanvasBrush& brush, const Look& look) {
  const ImVec2 centre = brush.at(ring.centre);
  const auto radius = static_cast<float>(ring.radius);
  if (ring.reach) {
    const auto reach = static_cast<float>(*ring.reach);
    brush.list.AddCircleFilled(centre, reach, packed(look.palette->accent, 0.10F));
    brush.list.AddCircle(centre, reach, packed(look.palette->accent, 0.8F), 0, look.px(1));
  }
  draw_circle({centre, radius, is_near ? 3.0F : 1.4F}, brush, look);
  const auto angle = static_cast<float>(ring.angle * std::numbers::pi / 180);
  const ImVec2 knob{centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)};
  const ImU32 fill = packed(ring.reach ? look.palette->accent : look.palette->popup);
  brush.list.AddCircleFilled(knob, look.px(5), fill);
  draw_circle({knob, look.px(5), 1.2F}, brush, look);
}

}  // namespace

void draw_handle_notes(Editor& editor, const CanvasBrush& brush, const PanelContext& context) {
  const Look& look = context.look;
  if (const auto ring = handle_ring(editor);
      ring && !editor.brush().is_on() && !editor.bone_tool().is_on()) {
    const auto& pointer = context.state.pointer;
    draw_ring(*ring, pointer && ring->is_near(*pointer, editor.canvas()), brush, look);
  }
  for (const HandleView& handle : handle_views(editor.draft())) {
    if (!handle.is_hovered || handle.name.empty()) continue;
    const ImVec2 place = brush.at(editor.canvas().to_pixel(handle.position));
    draw_plate(handle.name, {place.x, place.y - look.px(22)}, brush, look);
  }
}

}  // namespace foldless
