// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/bones.h"
#include "app/gui/canvas_brush.h"

namespace foldless {
namespace {

/// What is left free for the marks of the handles, and how wide a bone is. [design pixels]
constexpr double kMark = 9, kHalfWidth = 8;
/// Where it is widest, and how wide a short one may be there. [parts of its length]
constexpr double kShoulder = 0.22, kMostHalfWidth = 0.18;

/// A kite from a joint to the next, in pixels of the canvas: white in black is seen on every
/// colour.
void draw_bone(const Vec2& from, const Vec2& to, const CanvasBrush& brush, const Look& look) {
  const double mark = kMark * look.scale, whole = (to - from).norm();
  const double length = whole - 2 * mark;
  if (length < mark) return;
  const Vec2 along = (to - from) / whole, across(-along.y(), along.x());
  const Vec2 begin = from + mark * along;
  const double half = std::min(kHalfWidth * look.scale, kMostHalfWidth * length);
  const Vec2 shoulder = begin + kShoulder * length * along;
  const std::array<ImVec2, 4> kite{brush.at(begin), brush.at(shoulder + half * across),
                                   brush.at(begin + length * along),
                                   brush.at(shoulder - half * across)};
  brush.list.AddConvexPolyFilled(kite.data(), 4, IM_COL32(255, 255, 255, 110));
  // Side by side: a line round it would have long spikes at the sharp ends.
  for (const auto& [colour, width] : {std::pair{IM_COL32_BLACK, 3.6F}, {IM_COL32_WHITE, 1.6F}})
    for (std::size_t i = 0; i < kite.size(); ++i)
      brush.list.AddLine(kite[i], kite[(i + 1) % kite.size()], colour, look.px(width));
}

}  // namespace

void draw_bones(const Editor& editor, const CanvasBrush& brush, const PanelContext& context) {
  const Look& look = context.look;
  const Snapshot& shown = *editor.shown();
  const auto pixel_of_joint = [&](int id) {
    const auto handle = std::ranges::find(shown.handles, id, &Handle::id);
    return editor.canvas().to_pixel(shown.deformed.col(handle->vertex));
  };
  for (const Bones& bones : bones_of(editor.document().rig.bones, shown.handles))
    for (std::size_t i = 1; i < bones.size(); ++i)
      draw_bone(pixel_of_joint(bones[i - 1]), pixel_of_joint(bones[i]), brush, look);
  const Bones drawn = editor.bone_tool().chain();
  if (!drawn.empty() && context.state.pointer)
    draw_bone(pixel_of_joint(drawn.back()), *context.state.pointer, brush, look);
}

}  // namespace foldless
