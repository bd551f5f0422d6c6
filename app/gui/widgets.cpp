// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets.h"

#include <algorithm>
#include <cmath>

#include "app/gui/dialog_focus.h"
#include "app/gui/short_text.h"
#include "app/gui/tooltips.h"

namespace foldless {
bool icon_button(const IconButton& button, const Look& look) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Palette& p = *look.palette;
  const ImVec4 chosen{p.accent.x, p.accent.y, p.accent.z, 0.2F}, nothing{0, 0, 0, 0};
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  ImGui::PushStyleColor(ImGuiCol_Button,
                        button.is_main ? p.accent : (button.is_chosen ? chosen : nothing));
  if (button.is_main) ImGui::PushStyleColor(ImGuiCol_ButtonHovered, p.accent);
  ImGui::PushID(button.id);
  const bool pressed = ImGui::Button("##icon", {side, side});
  ImGui::PopID();
  ImGui::PopStyleColor(button.is_main ? 2 : 1);
  ImGui::PopStyleVar();
  const ImVec4& colour = button.is_main ? p.on_accent : (button.is_chosen ? p.accent : p.text);
  draw_icon(button.icon, {corner, side}, packed(colour, ImGui::GetStyle().Alpha), look);
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

void label_of_choice(std::string_view words, bool is_changed, const Look& look) {
  const float room = look.px(8);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (is_changed)
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {corner.x + room / 2 - look.px(1), corner.y + ImGui::GetFrameHeight() / 2}, look.px(2.2F),
        packed(look.palette->accent));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
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
  if (is_open) begin_tab_stops();
  return is_open;
}

void end_dialog() {
  end_tab_stops();
  ImGui::EndPopup();
}

void title_text(const char* words, const Look& look) {
  ImGui::PushFont(look.fonts.title);
  ImGui::TextUnformatted(words);
  ImGui::PopFont();
  ImGui::Dummy({0, look.px(2)});
}

void begin_controls(const char* id, const ImVec2& size, const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(4), look.px(2)});
  ImGui::BeginChild(id, size, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
  ImGui::PopStyleVar();
}

void begin_rows(const ImVec2& size, const Look& look) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2{ImGui::GetStyle().ItemSpacing.x, look.px(3)});
  ImGui::BeginChild("rows", size, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
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
