// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "app/editor/mirroring.h"
#include "app/gui/canvas_brush.h"

namespace foldless {
namespace {

/// How far the line goes on beyond the ends that are dragged. [design pixels]
constexpr double kBeyond = 24;

}  // namespace

void draw_mirror(const Editor& editor, const CanvasBrush& brush, const Look& look) {
  if (!is_mirror_on(editor)) return;
  const MirrorAxis& axis = editor.document().rig.mirror->axis;
  const Vec2 from = editor.canvas().to_pixel(axis.from), to = editor.canvas().to_pixel(axis.to);
  const Vec2 beyond = kBeyond * look.scale * (to - from).normalized();
  // White in black is seen on every colour.
  for (const auto& [colour, width] : {std::pair{IM_COL32_BLACK, 3.2F}, {IM_COL32_WHITE, 1.4F}}) {
    brush.list.AddLine(brush.at(from - beyond), brush.at(to + beyond), colour, look.px(width));
  }
  for (const Vec2& end : {from, to}) {
    const ImVec2 knob = brush.at(end);
    brush.list.AddCircleFilled(knob, look.px(6), IM_COL32_BLACK);
    brush.list.AddCircleFilled(knob, look.px(4.6F), IM_COL32_WHITE);
    brush.list.AddCircleFilled(knob, look.px(3), packed(look.palette->accent));
  }
}

}  // namespace foldless
