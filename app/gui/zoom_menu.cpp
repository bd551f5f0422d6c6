// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/zoom_menu.h"

#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/commands.h"
#include "app/gui/command_item.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr const char* kPopup = "##zoom levels";
constexpr std::array kLevels{25, 50, 100, 200, 400};  // per cent

void draw_levels(Editor& editor) {
  const double percent = 100 * editor.view().zoom_level();
  for (const int level : kLevels) {
    const bool is_this = std::abs(percent - level) < 0.01 * level;
    if (ImGui::MenuItem((std::to_string(level) + " %").c_str(), nullptr, is_this))
      editor.view().set_zoom_level(level / 100.0);
  }
}

/// It has the keyboard when the menu opens: a number and Enter is the shortest way.
void draw_field(Editor& editor, const Look& look) {
  double percent = 100 * editor.view().zoom_level();
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(look.px(90));
  constexpr ImGuiInputTextFlags kPercentFlags =
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  if (ImGui::InputDouble("##percent", &percent, 0, 0, "%.4g", kPercentFlags)) {
    editor.view().set_zoom_level(percent / 100);
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine(0, look.px(6));
  ImGui::TextUnformatted("%");
}

}  // namespace

std::string zoom_words(const Editor& editor) {
  const double percent = 100 * editor.view().zoom_level();
  std::array<char, 32> text{};
  const bool is_plain = percent >= 100 && percent < 99999.5;
  std::snprintf(text.data(), text.size(), is_plain ? "%.0f %%" : "%.3g %%", percent);
  return text.data();
}

float zoom_button_width(const Editor& editor, const Look& look) {
  return ImGui::CalcTextSize(zoom_words(editor).c_str()).x + 2 * look.px(7);
}

void draw_zoom_menu(Editor& editor, float right, const Look& look) {
  ImGui::SameLine(right - zoom_button_width(editor, look));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{look.px(7), 0});
  if (ImGui::Button((zoom_words(editor) + "##zoom").c_str())) ImGui::OpenPopup(kPopup);
  ImGui::PopStyleVar();
  tooltip("Magnification: choose another, or type one.", look);
  const ImVec2 corner{ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y - look.px(6)};
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 1});
  ImGui::PushFont(look.fonts.text);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{look.px(10), look.px(7)});
  if (ImGui::BeginPopup(kPopup)) {
    draw_levels(editor);
    ImGui::Separator();
    for (const char* name : {"view.fit", "view.fit_selection", "view.fit_canvas"})
      draw_command_item(*find_command(name), editor);
    ImGui::Separator();
    draw_field(editor, look);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace foldless
