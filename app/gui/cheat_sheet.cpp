// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "app/editor/keymap.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

struct Gesture {
  const char* input;
  const char* effect;
};

constexpr std::array<Gesture, 11> kGestures{{
    {"Click", "Place a handle on the mesh"},
    {"Drag", "Place and bend in one go"},
    {"Drag a handle", "Bend"},
    {"Drag its ring", "Turn the mesh round it"},
    {"Shift+click", "Add to the selection"},
    {"Drag on empty", "Select in a box"},
    {"L+drag", "Select with a lasso"},
    {"Wheel", "Zoom about the pointer"},
    {"Middle drag", "Move the view"},
    {"Space+drag", "Move the view"},
    {"Ctrl+click a slider", "Type a number"},
}};

void heading(const char* words, const Look& look) {
  ImGui::PushFont(look.fonts.bold);
  ImGui::TextColored(look.palette->accent, "%s", words);
  ImGui::PopFont();
}

void draw_row(const std::string& keys, const std::string& effect, const Look& look) {
  key_cap(keys, look);
  ImGui::SameLine(look.px(132));
  ImGui::TextUnformatted(effect.c_str());
}

void draw_gestures(const Look& look) {
  heading("Mouse", look);
  for (const Gesture& gesture : kGestures) draw_row(gesture.input, gesture.effect, look);
}

void draw_menu(const char* menu, const Keymap& keys, const Look& look) {
  ImGui::Spacing();
  heading(menu, look);
  for (const KeyRow& row : keys.rows())
    if (const std::string words = keys.words(row.name); row.menu == menu && !words.empty())
      draw_row(words, row.title, look);
}

/// What opened it closes it.
bool is_own_key_pressed(const Keymap& keymap) {
  return std::ranges::any_of(keymap.keys("help.keys"),
                             [](const Shortcut& shortcut) { return takes_shortcut(shortcut); });
}

}  // namespace

void draw_cheat_sheet(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const char* id = "##cheat sheet";
  if (std::exchange(context.state.opens_cheat_sheet, false)) ImGui::OpenPopup(id);
  centre_next_window({1000, 540}, look);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(18), look.px(16)});
  const bool is_open = ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  if (!is_open) return;
  if (is_own_key_pressed(editor.keys())) ImGui::CloseCurrentPopup();
  title_text("Keys and mouse", look);
  const int columns = ImGui::GetContentRegionAvail().x > look.px(840) ? 3 : 2;
  const Keymap& keymap = editor.keys();
  if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    draw_gestures(look);
    draw_menu("Handles", keymap, look);
    draw_menu("Solve", keymap, look);
    draw_menu("Motion", keymap, look);
    ImGui::TableNextColumn();
    draw_menu("File", keymap, look);
    draw_menu("Edit", keymap, look);
    draw_menu("Help", keymap, look);
    ImGui::TableNextColumn();
    draw_menu("View", keymap, look);
    ImGui::EndTable();
  }
  ImGui::EndPopup();
}

}  // namespace foldless
