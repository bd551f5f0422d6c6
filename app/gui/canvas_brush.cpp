// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/canvas_brush.h"

namespace foldless {

void draw_plate(const std::string& words, const ImVec2& middle, const CanvasBrush& brush,
                const Look& look) {
  ImFont* font = look.fonts.small;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.c_str(), nullptr);
  const ImVec2 corner{middle.x - size.x / 2, middle.y - size.y / 2};
  const float margin = look.px(4);
  brush.list.AddRectFilled({corner.x - margin, corner.y - look.px(2)},
                           {corner.x + size.x + margin, corner.y + size.y + look.px(2)},
                           packed(look.palette->popup, 0.92F), look.px(4));
  brush.list.AddText(font, font->FontSize, corner, packed(look.palette->text), words.c_str());
}

}  // namespace foldless
