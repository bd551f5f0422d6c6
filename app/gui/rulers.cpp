// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "app/gui/panels.h"
#include "app/gui/round_ticks.h"

namespace foldless {
namespace {

/// Between numbers, and between ticks, at least. [design pixels]
constexpr float kNumberDistance = 70, kTickDistance = 7;
constexpr float kShortTick = 5;  // design pixels

/// One of the two rulers as a line from its start to its end, where x is along it and y across
/// from the canvas outwards.
struct RulerLine {
  Rectangle place;
  bool is_upright = false;
  double at_start = 0;  ///< coordinate at the left end, or at the bottom
  double per_unit = 1;  ///< pixels

  float length() const { return is_upright ? place.height : place.width; }
  float thickness() const { return is_upright ? place.width : place.height; }
  double at_end() const { return at_start + length() / per_unit; }
  float along(double coordinate) const {
    return static_cast<float>((coordinate - at_start) * per_unit);
  }
  ImVec2 point(float along, float across) const {
    if (is_upright) return {place.x + place.width - across, place.y + place.height - along};
    return {place.x + along, place.y + place.height - across};
  }
};

std::string words_of(double value, double step) {
  std::array<char, 32> text{};
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  if (decimals <= 4 && std::abs(value) < 1e6)
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value + 0.0);  // never -0
  else
    std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

/// A number right of its tick at `along`, where there is room; along an upright ruler it reads from
/// below.
void draw_number(const std::string& words, float along, const RulerLine& ruler, const Look& look) {
  ImFont* font = look.fonts.small;
  const float start = along + look.px(3);
  const float width = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.c_str()).x;
  if (start + width > ruler.length()) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 corner = ruler.point(start, ruler.thickness());
  const int first = list.VtxBuffer.Size;
  list.AddText(font, font->FontSize, corner, packed(look.palette->dim), words.c_str());
  if (!ruler.is_upright) return;
  for (int i = first; i < list.VtxBuffer.Size; ++i) {
    ImVec2& p = list.VtxBuffer[i].pos;
    p = {corner.x + (p.y - corner.y), corner.y - (p.x - corner.x)};
  }
}

void draw_ruler(const RulerLine& ruler, std::optional<float> pointer, const Look& look) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Rectangle& place = ruler.place;
  list.AddRectFilled({place.x, place.y}, {place.x + place.width, place.y + place.height},
                     packed(look.palette->bar));
  list.AddLine(ruler.point(0, 0), ruler.point(ruler.length(), 0), packed(look.palette->border),
               look.px(1));
  const ImU32 dim = packed(look.palette->dim);
  const double step = round_step(look.px(kNumberDistance) / ruler.per_unit);
  const double fine_step = round_step(look.px(kTickDistance) / ruler.per_unit);
  for (const double value : multiples(fine_step, ruler.at_start, ruler.at_end())) {
    const float at = std::round(ruler.along(value));
    list.AddLine(ruler.point(at, 0), ruler.point(at, look.px(kShortTick)), dim, look.px(1));
  }
  for (const double value : multiples(step, ruler.at_start, ruler.at_end())) {
    const float at = std::round(ruler.along(value));
    list.AddLine(ruler.point(at, 0), ruler.point(at, ruler.thickness()), dim, look.px(1));
    draw_number(words_of(value, step), at, ruler, look);
  }
  if (!pointer) return;
  list.AddLine(ruler.point(*pointer, 0), ruler.point(*pointer, ruler.thickness()),
               packed(look.palette->accent), look.px(2));
}

/// `pointer`: in pixels of the canvas.
void draw_pair(const Rulers& rulers, const Canvas& canvas, const std::optional<Vec2>& pointer,
               const Look& look) {
  const Vec2 corner = canvas.to_world({0, canvas.height});  // the lower left one
  const double per_unit = canvas.camera.pixels_per_unit;
  // The upper one begins over the left one.
  const float inset = rulers.left.width;
  RulerLine top{rulers.top, false, corner.x() - inset / per_unit, per_unit};
  const RulerLine left{rulers.left, true, corner.y(), per_unit};
  std::optional<float> x, y;
  if (pointer) {
    x = inset + static_cast<float>(pointer->x());
    y = static_cast<float>(canvas.height - pointer->y());
  }
  draw_ruler(top, x, look);
  draw_ruler(left, y, look);
  ImGui::GetBackgroundDrawList()->AddRectFilled(
      {rulers.top.x, rulers.top.y}, {rulers.top.x + inset, rulers.top.y + rulers.top.height},
      packed(look.palette->bar));
}

}  // namespace

void draw_rulers(const Editor& editor, const PanelContext& context) {
  const Layout& layout = context.layout;
  if (layout.rulers.top.width > 0)
    draw_pair(layout.rulers, editor.canvas(), context.state.pointer, context.look);
  if (layout.side_rulers.top.width > 0)
    draw_pair(layout.side_rulers, editor.view().side_pane().pane(), std::nullopt, context.look);
}

}  // namespace foldless
