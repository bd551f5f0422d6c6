// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/dialog_focus.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "app/editor/input.h"
#include "app/gui/choice_list.h"
#include "app/gui/key_press.h"

namespace foldless {
namespace {

/// What a dialog remembers in its window: that the focus was last moved by a key, that what has it
/// was drawn in the last frame, and the control that turned out to be a field of text.
constexpr ImGuiID kByKeyboard = 0xF0C05000;
constexpr ImGuiID kIsAlive = 0xF0C05001;
constexpr ImGuiID kTextField = 0xF0C05002;

bool is_pressed(Key key, bool repeats) {
  return ImGui::IsKeyPressed(static_cast<int>(key), repeats);
}

/// Used once: neither the dialog nor a control sees it.
bool uses_press(Key key) { return take_press(static_cast<int>(key)); }

bool is_modal(const ImGuiWindow& window) { return (window.Flags & ImGuiWindowFlags_Modal) != 0; }

/// The topmost dialog or list of a combo box; null: there is none, or another popup is over it.
ImGuiWindow* focused_popup() {
  const auto& open = ImGui::GetCurrentContext()->OpenPopupStack;
  ImGuiWindow* window = open.empty() ? nullptr : open.back().Window;
  if (!window) return nullptr;
  return is_modal(*window) || std::string_view(window->Name).starts_with("##Combo_") ? window
                                                                                     : nullptr;
}

bool has_just_opened() {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.OpenPopupStack.back().OpenFrameCount >= g.FrameCount - 1;
}

/// The control with the focus is one of its own.
bool has_focus(const ImGuiWindow& popup) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  return g.NavId != 0 && g.NavWindow && g.NavWindow->RootWindow == &popup;
}

/// These choose in the list of a dialog, which Enter then takes.
bool is_list_walked() {
  static constexpr std::array kListKeys{Key::up,        Key::down, Key::page_up,
                                        Key::page_down, Key::home, Key::end};
  return std::ranges::any_of(kListKeys, [](Key key) { return is_pressed(key, true); });
}

void walk_controls(ImGuiWindow& dialog, bool backwards) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  if (!g.NavWindow || g.NavWindow->RootWindow != &dialog) ImGui::FocusWindow(&dialog);
  ImGui::NavMoveRequestSubmit(
      ImGuiDir_None, backwards ? ImGuiDir_Up : ImGuiDir_Down, ImGuiNavMoveFlags_Tabbing,
      ImGuiScrollFlags_KeepVisibleEdgeX | ImGuiScrollFlags_KeepVisibleEdgeY);
  g.NavTabbingResultFirst.Clear();
  const bool is_first = !has_focus(dialog) || !dialog.StateStorage.GetBool(kIsAlive);
  g.NavTabbingDir = backwards ? -1 : (is_first ? 0 : 1);
  g.NavTabbingCounter = -1;
}

bool walks(ImGuiWindow& popup) {
  if (!is_modal(popup)) return walk_choices(popup);
  if (!is_pressed(Key::tab, true)) return false;
  walk_controls(popup, ImGui::GetIO().KeyShift);
  return true;
}

/// In a field Space is typed, and Enter is the dialog's.
void press_focused(bool is_field) {
  if (is_field || (!uses_press(Key::space) && !uses_press(Key::enter))) return;
  ImGui::ActivateItem(ImGui::GetCurrentContext()->NavId);
}

}  // namespace

void follow_dialog_focus(bool captures_keys) {
  ImGuiWindow* popup = focused_popup();
  ImGui::GetIO().KeyMap[ImGuiKey_Tab] = popup ? -1 : static_cast<int>(Key::tab);
  if (!popup || captures_keys) return;
  ImGuiStorage& memory = popup->StateStorage;
  if (has_just_opened() || ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
      (is_modal(*popup) && is_list_walked()))
    memory.SetBool(kByKeyboard, false);
  if (ImGui::GetIO().WantTextInput)
    memory.SetInt(kTextField, static_cast<int>(ImGui::GetActiveID()));
  if (walks(*popup)) return memory.SetBool(kByKeyboard, true);
  if (!memory.GetBool(kByKeyboard) || !memory.GetBool(kIsAlive)) return;
  const ImGuiID focused = ImGui::GetCurrentContext()->NavId;
  press_focused(static_cast<ImGuiID>(memory.GetInt(kTextField)) == focused);
}

void draw_dialog_focus(const Look& look) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGuiWindow* popup = focused_popup();
  if (!popup) return;
  const bool is_alive = has_focus(*popup) && g.NavIdIsAlive;
  popup->StateStorage.SetBool(kIsAlive, is_alive);
  if (!is_alive || !popup->StateStorage.GetBool(kByKeyboard)) return;
  ImRect place = ImGui::WindowRectRelToAbs(g.NavWindow, g.NavWindow->NavRectRel[g.NavLayer]);
  place.Expand(look.px(2.5F));
  ImRect room = g.NavWindow->InnerRect;
  room.Expand(look.px(4));
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.PushClipRect(room.Min, room.Max);
  list.AddRect(place.Min, place.Max, packed(look.palette->accent), look.px(5), 0, look.px(2));
  list.PopClipRect();
}

void begin_tab_stops() { ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true); }
void end_tab_stops() { ImGui::PopItemFlag(); }
void begin_list_rows() { ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true); }
void end_list_rows() { ImGui::PopItemFlag(); }

}  // namespace foldless
