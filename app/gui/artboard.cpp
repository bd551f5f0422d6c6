// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "app/gui/panels.h"

namespace foldless {
namespace {

void draw_outline_of(const TextureBox& box, const Canvas& canvas, const Rectangle& place,
                     const Look& look) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto at = [&](double x, double y) {
    const Vec2 pixel = canvas.to_pixel({x, y});
    return ImVec2{place.x + static_cast<float>(pixel.x()), place.y + static_cast<float>(pixel.y())};
  };
  list.PushClipRect({place.x, place.y}, {place.x + place.width, place.y + place.height});
  list.AddRect(at(box.min.x(), box.max.y()), at(box.max.x(), box.min.y()),
               packed(look.palette->dim), 0, 0, look.px(1));
  list.PopClipRect();
}

}  // namespace

void draw_artboard(const Editor& editor, const PanelContext& context) {
  const auto box = editor.view().artboard();
  if (!box || !context.state.settings.shows_artboard || editor.view().are_overlays_hidden()) return;
  const Layout& layout = context.layout;
  draw_outline_of(*box, editor.canvas(), layout.canvas, context.look);
  if (editor.view().beside() != Beside::nothing)
    draw_outline_of(*box, editor.view().side_pane().pane(), layout.side, context.look);
}

}  // namespace foldless
