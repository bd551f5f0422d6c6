// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets.h"

#include <algorithm>
#include <cmath>

#include "app/gui/short_text.h"
#include "app/gui/tooltips.h"

namespace foldless {
namespace {

/// Draws in a unit square, y down.
struct IconBrush {
  ImDrawList& list;
  ImVec2 corner;
  float size;
  ImU32 colour;

  ImVec2 at(float x, float y) const { return {corner.x + x * size, corner.y + y * size}; }
  void right_triangle(float x0, float x1) const {
    list.AddTriangleFilled(at(x0, 0.1F), at(x0, 0.9F), at(x1, 0.5F), colour);
  }
  void left_triangle(float x0, float x1) const {
    list.AddTriangleFilled(at(x1, 0.1F), at(x1, 0.9F), at(x0, 0.5F), colour);
  }
  void bar(float x0, float x1) const { list.AddRectFilled(at(x0, 0.1F), at(x1, 0.9F), colour); }
};

/// An arc that goes back on itself, with an arrow head.
void draw_reset(const IconBrush& b) {
  const float thickness = std::max(1.5F, b.size * 0.13F);
  b.list.PathArcTo(b.at(0.5F, 0.54F), b.size * 0.36F, -2.4F, 2.6F);
  b.list.PathStroke(b.colour, 0, thickness);
  b.list.AddTriangleFilled(b.at(0.02F, 0.42F), b.at(0.46F, 0.4F), b.at(0.14F, 0.06F), b.colour);
}

void draw_up(const IconBrush& b) {
  const float thickness = std::max(1.5F, b.size * 0.13F);
  b.list.AddLine(b.at(0.5F, 0.12F), b.at(0.5F, 0.9F), b.colour, thickness);
  b.list.AddLine(b.at(0.5F, 0.12F), b.at(0.16F, 0.46F), b.colour, thickness);
  b.list.AddLine(b.at(0.5F, 0.12F), b.at(0.84F, 0.46F), b.colour, thickness);
}

void draw_icon(const IconBrush& b, Icon icon) {
  switch (icon) {
    case Icon::play: b.right_triangle(0.18F, 0.92F); break;
    case Icon::pause:
      b.bar(0.16F, 0.4F);
      b.bar(0.6F, 0.84F);
      break;
    case Icon::step:
      b.bar(0.1F, 0.26F);
      b.right_triangle(0.36F, 0.94F);
      break;
    case Icon::stop: b.list.AddRectFilled(b.at(0.14F, 0.14F), b.at(0.86F, 0.86F), b.colour); break;
    case Icon::first:
      b.bar(0.1F, 0.24F);
      b.left_triangle(0.26F, 0.88F);
      break;
    case Icon::back: b.left_triangle(0.14F, 0.8F); break;
    case Icon::last:
      b.right_triangle(0.12F, 0.74F);
      b.bar(0.76F, 0.9F);
      break;
    case Icon::up: draw_up(b); break;
    case Icon::reset: draw_reset(b); break;
    case Icon::film:
      b.list.AddRect(b.at(0.06F, 0.14F), b.at(0.94F, 0.86F), b.colour, 0, 0, b.size * 0.12F);
      b.right_triangle(0.36F, 0.72F);
      break;
  }
}

}  // namespace

bool icon_button(const IconButton& button, const Look& look) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (button.is_main) {
    ImGui::PushStyleColor(ImGuiCol_Button, look.palette->accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look.palette->accent);
  }
  ImGui::PushID(button.id);
  const bool pressed = ImGui::Button("##icon", {side, side});
  ImGui::PopID();
  if (button.is_main) ImGui::PopStyleColor(2);
  const float margin = std::round(side * 0.28F);
  const ImVec4& colour = button.is_main ? look.palette->on_accent : look.palette->text;
  draw_icon({*ImGui::GetWindowDrawList(),
             {corner.x + margin, corner.y + margin},
             side - 2 * margin,
             packed(colour, ImGui::GetStyle().Alpha)},
            button.icon);
  tooltip(button.tip, look);
  return pressed;
}

bool main_button(const char* label, const Look& look) {
  ImGui::PushStyleColor(ImGuiCol_Button, look.palette->accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look.palette->accent);
  ImGui::PushStyleColor(ImGuiCol_Text, look.palette->on_accent);
  const bool pressed = ImGui::Button(label);
  ImGui::PopStyleColor(3);
  return pressed;
}

bool section(const char* title, bool is_open, const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight();
  if (ImGui::InvisibleButton("##heading", {ImGui::GetContentRegionAvail().x, height}))
    is_open = !is_open;
  const ImVec4& colour = ImGui::IsItemHovered() ? look.palette->text : look.palette->dim;
  const float r = look.px(3.2F);
  const ImVec2 c{corner.x + r, corner.y + height / 2};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_open)
    list.AddTriangleFilled({c.x - r, c.y - r * 0.6F}, {c.x + r, c.y - r * 0.6F}, {c.x, c.y + r},
                           packed(colour));
  else
    list.AddTriangleFilled({c.x - r * 0.6F, c.y - r}, {c.x - r * 0.6F, c.y + r}, {c.x + r, c.y},
                           packed(colour));
  ImFont* font = look.fonts.bold;
  list.AddText(font, font->FontSize,
               {corner.x + look.px(14), corner.y + (height - font->FontSize) / 2},
               packed(look.palette->text), title);
  return is_open;
}

void dim_text(const std::string& text, const Look& look) {
  ImGui::PushFont(look.fonts.small);
  ImGui::PushStyleColor(ImGuiCol_Text, look.palette->dim);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

void tooltip(const std::string& text, const Look& look) {
  if (look.tooltips) look.tooltips->show(text, look);
}

void key_cap(const std::string& key, const Look& look) {
  ImGui::PushFont(look.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(key.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 padding{look.px(5), look.px(1)};
  const ImVec2 end{corner.x + size.x + 2 * padding.x, corner.y + size.y + 2 * padding.y};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, end, packed(look.palette->frame), look.px(3));
  list.AddRect(corner, end, packed(look.palette->border), look.px(3));
  list.AddText({corner.x + padding.x, corner.y + padding.y}, packed(look.palette->text),
               key.c_str());
  ImGui::PopFont();
  ImGui::Dummy({end.x - corner.x, end.y - corner.y});
}

void centre_next_window(const ImVec2& size, const Look& look) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 fitted{std::min(look.px(size.x), display.x * 0.96F),
                      std::min(look.px(size.y), display.y * 0.94F)};
  ImGui::SetNextWindowSize(fitted);
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
}

bool begin_dialog(const char* id, const Look& look, std::optional<ImVec2> size) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                           ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;
  if (size) {
    centre_next_window(*size, look);
  } else {
    ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    flags |= ImGuiWindowFlags_AlwaysAutoResize;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(18), look.px(16)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0F, std::floor(look.scale)));
  const bool is_open = ImGui::BeginPopupModal(id, nullptr, flags);
  ImGui::PopStyleVar(3);
  return is_open;
}

void end_dialog() { ImGui::EndPopup(); }

void title_text(const char* words, const Look& look) {
  ImGui::PushFont(look.fonts.title);
  ImGui::TextUnformatted(words);
  ImGui::PopFont();
  ImGui::Dummy({0, look.px(2)});
}

void begin_rows(const ImVec2& size, const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{ImGui::GetStyle().ItemSpacing.x, look.px(3)});
  ImGui::BeginChild("rows", size, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
}

float rows_height(std::size_t rows, const Look& look) {
  return ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(rows) + look.px(2);
}

bool begin_combo(const char* id, const std::string& choice, ImGuiComboFlags flags) {
  const float room =
      ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::BeginCombo(id, elided(choice, room).c_str(), flags);
}

void slider_line(double position, const Look& look) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float inset = look.px(3);
  const float width = high.x - low.x - 2 * inset;
  const auto end = static_cast<float>(std::clamp(position, 0.0, 1.0)) * width;
  ImGui::GetWindowDrawList()->AddRectFilled(
      {low.x + inset, high.y - look.px(3)}, {low.x + inset + end, high.y - look.px(1)},
      packed(look.palette->accent, ImGui::GetStyle().Alpha), look.px(1));
}

}  // namespace foldless
