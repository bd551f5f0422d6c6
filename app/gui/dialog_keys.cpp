// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialog_keys.h"

#include <imgui_internal.h>

#include <algorithm>

#include "app/gui/dialog_focus.h"
#include "app/gui/key_press.h"

namespace foldless {
namespace {

constexpr int kPage = 10;  // rows

void forget_held_keys() {
  const ImGuiIO& io = ImGui::GetIO();
  for (int index = 0; index < IM_ARRAYSIZE(io.KeysDown); ++index)
    if (io.KeysDownDuration[index] > 0) forget_key(index);
}

/// In the frame in which it appears, the key press is the one that opened it.
bool has_keys() {
  return !ImGui::IsWindowAppearing() && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
}

bool is_dialog(const ImGuiPopupData& popup) {
  return popup.Window && (popup.Window->Flags & ImGuiWindowFlags_Modal);
}

/// Submenus go together with their menu.
void close_top_popup() {
  const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
  int level = open.Size - 1;
  const auto is_submenu = [&open](int i) {
    return i > 0 && open[i].Window && (open[i].Window->Flags & ImGuiWindowFlags_ChildMenu) &&
           !is_dialog(open[i - 1]);
  };
  while (is_submenu(level)) --level;
  ImGui::ClosePopupToLevel(level, true);
}

Modifiers held_modifiers() {
  const ImGuiIO& io = ImGui::GetIO();
  return {.shift = io.KeyShift, .control = io.KeyCtrl, .alt = io.KeyAlt};
}

bool is_walked(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

}  // namespace

void begin_dialog_keys(bool captures_keys) {
  follow_dialog_focus(captures_keys);
  const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
  if (open.empty()) return;
  if (open.back().OpenFrameCount == ImGui::GetFrameCount() - 1) forget_held_keys();
  if (!is_dialog(open.back()) && take_press(ImGui::GetKeyIndex(ImGuiKey_Escape))) close_top_popup();
}

DialogKeys dialog_keys(TextKeys text_keys) {
  const bool is_typing = ImGui::GetIO().WantTextInput && text_keys == TextKeys::field;
  if (!has_keys() || is_typing) return {};
  return {take_press(ImGui::GetKeyIndex(ImGuiKey_Enter)),
          take_press(ImGui::GetKeyIndex(ImGuiKey_Escape))};
}

bool takes_key(Key key) { return has_keys() && take_press(static_cast<int>(key)); }

bool takes_shortcut(const Shortcut& shortcut) {
  return shortcut.modifiers == held_modifiers() && takes_key(shortcut.key);
}

std::optional<Shortcut> take_any_key() {
  for (int key = 1; key <= static_cast<int>(kLastKey); ++key)
    if (takes_key(static_cast<Key>(key))) return Shortcut{static_cast<Key>(key), held_modifiers()};
  return std::nullopt;
}

std::optional<std::size_t> walk_list(std::size_t selected, std::size_t count, bool has_text) {
  if (count == 0 || !has_keys()) return std::nullopt;
  const int last = static_cast<int>(count) - 1;
  if (is_walked(ImGuiKey_Home) && !has_text) return 0;
  if (is_walked(ImGuiKey_End) && !has_text) return count - 1;
  int by = 0;
  if (is_walked(ImGuiKey_DownArrow)) by = 1;
  if (is_walked(ImGuiKey_UpArrow)) by = -1;
  if (is_walked(ImGuiKey_PageDown)) by = kPage;
  if (is_walked(ImGuiKey_PageUp)) by = -kPage;
  if (by == 0) return std::nullopt;
  return static_cast<std::size_t>(std::clamp(static_cast<int>(selected) + by, 0, last));
}

}  // namespace foldless
