// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "app/editor/swing_centre.h"
#include "app/gui/canvas_brush.h"

namespace foldless {

void draw_swings(const Editor& editor, const CanvasBrush& brush, const Look& look) {
  const Canvas& canvas = editor.canvas();
  const Animation& animation = editor.motion().animation();
  for (const std::size_t i : shown_swings(editor)) {
    const TurningGroup& group = animation.groups[i];
    const ImVec2 centre = brush.at(canvas.to_pixel(group.center));
    const ImVec2 grip = brush.at(swing_grip(canvas, group.center));
    const float r = look.px(6);
    // White in black is seen on every colour.
    for (const auto& [colour, width] : {std::pair{IM_COL32_BLACK, 3.2F}, {IM_COL32_WHITE, 1.4F}}) {
      brush.list.AddLine({centre.x - r, centre.y}, {centre.x + r, centre.y}, colour,
                         look.px(width));
      brush.list.AddLine({centre.x, centre.y - r}, grip, colour, look.px(width));
      for (const Handle& handle : editor.shown()->handles)
        if (std::ranges::find(group.handles, handle.id) != group.handles.end())
          brush.list.AddLine(centre, brush.at(canvas.to_pixel(handle.target)), colour,
                             look.px(width / 2));
    }
    brush.list.AddCircleFilled(grip, look.px(6), IM_COL32_BLACK);
    brush.list.AddCircleFilled(grip, look.px(4.6F), IM_COL32_WHITE);
    brush.list.AddCircleFilled(grip, look.px(3), packed(look.palette->accent));
  }
}

}  // namespace foldless
