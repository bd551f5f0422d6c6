// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/gui/choice_list.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/directory.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr const char* kHint =
    "Press a key's button, then the key. Delete takes the key away, Esc leaves it as it is.";

std::string words_of(const std::vector<Shortcut>& keys) {
  std::string words;
  for (const Shortcut& key : keys) words.append(words.empty() ? "" : ", ").append(words_of(key));
  return words;
}

/// The command beside `command` that has one of the keys, or null.
const KeyRow* owner_of(std::span<const Shortcut> keys, const std::string& command,
                       const Keymap& keymap) {
  for (const Shortcut& key : keys)
    if (const KeyRow* owner = keymap.find(keymap.command_of(key)); owner && owner->name != command)
      return owner;
  return nullptr;
}

bool matches(const KeyRow& row, const Keymap& keymap, const std::string& search) {
  const std::string words = row.menu + ": " + row.title + " " + words_of(keymap.keys(row.name));
  return matches_filter(words, search);
}

void draw_presets(Keymap& keymap, const Look& look) {
  const KeyPreset* current = find_key_preset(keymap.choice().preset);
  ImGui::SetNextItemWidth(look.px(130));
  if (begin_combo("##preset", std::string(current ? current->title : ""))) {
    for (const KeyPreset& preset : key_presets()) {
      if (!choice_entry(preset.title.data(), &preset == current)) continue;
      KeyChoice choice = keymap.choice();
      choice.preset = preset.name;
      keymap.choose(std::move(choice));
    }
    ImGui::EndCombo();
  }
  tooltip("Keys of other programs, where they mean the same. What you changed stays.", look);
}

}  // namespace

void KeysDialog::open() {
  *this = {};
  opens_now_ = true;
}

void KeysDialog::draw(Editor& editor, const Look& look) {
  if (std::exchange(opens_now_, false)) ImGui::OpenPopup("##keys");
  if (!begin_dialog("##keys", look, ImVec2{600, 560})) return;
  Keymap& keymap = editor.keys();
  title_text("Keys", look);
  draw_head(keymap, look);
  if (is_capturing()) capture(keymap);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, look.palette->window);
  begin_controls("rows", {0, -2 * ImGui::GetFrameHeightWithSpacing() - look.px(4)}, look);
  draw_rows(keymap, look);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  draw_foot(keymap, look);
  end_dialog();
}

void KeysDialog::draw_head(Keymap& keymap, const Look& look) {
  draw_presets(keymap, look);
  ImGui::SameLine();
  const char* reset = "Reset all";
  const float button = ImGui::CalcTextSize(reset).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  ImGui::InputTextWithHint("##search", "Search by command or key", &search_);
  ImGui::SameLine();
  ImGui::BeginDisabled(keymap.choice().changes.empty());
  if (ImGui::Button(reset)) keymap.reset();
  ImGui::EndDisabled();
  tooltip("All keys as in the preset", look);
}

void KeysDialog::draw_rows(Keymap& keymap, const Look& look) {
  if (!ImGui::BeginTable("keys", 3)) return;
  ImGui::TableSetupColumn("command", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthFixed, look.px(170));
  ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFrameHeight());
  bool has_rows = false;
  for (const char* menu : {"File", "Edit", "Handles", "Solve", "Motion", "View", "Help"}) {
    bool has_heading = false;
    for (const KeyRow& row : keymap.rows()) {
      if (row.menu != menu || !matches(row, keymap, search_)) continue;
      ImGui::TableNextRow();
      if (!std::exchange(has_heading, true)) {
        ImGui::TableNextColumn();
        ImGui::PushFont(look.fonts.bold);
        ImGui::TextColored(look.palette->accent, "%s", menu);
        ImGui::PopFont();
        ImGui::TableNextRow();
      }
      has_rows = true;
      draw_row(row, keymap, look);
    }
  }
  ImGui::EndTable();
  if (!has_rows) dim_text("Nothing has these letters.", look);
}

void KeysDialog::draw_row(const KeyRow& row, Keymap& keymap, const Look& look) {
  ImGui::PushID(row.name.c_str());
  ImGui::TableNextColumn();
  const bool is_changed = keymap.is_changed(row.name);
  label_of_choice(row.title, is_changed, look);
  ImGui::TableNextColumn();
  const std::string words = words_of(keymap.keys(row.name));
  if (row.is_fixed) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(look.palette->dim, "%s, fixed", words.c_str());
  } else {
    const bool is_captured = row.name == captures_for_;
    const std::string label = is_captured ? "Press a key…" : words;
    if (ImGui::Button((label + "###key").c_str(), {-1, 0})) {
      captures_for_ = row.name;
      conflict_.reset();
      refusal_.clear();
    }
  }
  ImGui::TableNextColumn();
  if (is_changed && icon_button({"reset", Icon::reset, "Back to the preset"}, look))
    give(row.name, keymap.preset_keys(row.name), keymap);
  ImGui::PopID();
}

void KeysDialog::draw_foot(Keymap& keymap, const Look& look) {
  if (conflict_ || !refusal_.empty()) {
    ImGui::PushFont(look.fonts.small);
    ImGui::TextColored(look.palette->warning, "%s",
                       conflict_ ? conflict_->words.c_str() : refusal_.c_str());
    ImGui::PopFont();
  } else {
    dim_text(kHint, look);
  }
  const DialogKeys keys = dialog_keys();
  if (conflict_) {
    const bool takes = main_button("Take it", look) || keys.takes;
    ImGui::SameLine();
    const bool leaves = ImGui::Button("Leave it there") || keys.leaves;
    if (takes) keymap.set(conflict_->command, conflict_->keys);
    if (takes || leaves) conflict_.reset();
    return;
  }
  if (main_button("Close", look) || keys.takes || keys.leaves) ImGui::CloseCurrentPopup();
}

void KeysDialog::capture(Keymap& keymap) {
  const auto key = take_any_key();
  if (!key && !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
  const bool leaves = !key || key->key == Key::escape;
  const bool removes = key && (key->key == Key::del || key->key == Key::backspace);
  refusal_ = leaves || removes ? "" : keymap.refusal_of(*key);
  if (!refusal_.empty()) return;
  const std::string command = std::exchange(captures_for_, "");
  if (leaves) return;
  give(command, removes ? std::vector<Shortcut>() : std::vector{*key}, keymap);
}

void KeysDialog::give(const std::string& command, std::vector<Shortcut> keys, Keymap& keymap) {
  conflict_.reset();
  const KeyRow* owner = owner_of(keys, command, keymap);
  if (!owner) return keymap.set(command, std::move(keys));
  std::string words = words_of(keys);
  words.append(" is the key of “").append(owner->title).append("”.");
  conflict_ = {command, std::move(keys), std::move(words)};
}

}  // namespace foldless
