// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/choice_list.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "app/editor/input.h"

namespace foldless {
namespace {

/// What a list remembers in its window from one frame to the next: how many entries it had, the
/// one that is to have the focus, the frame, and of each entry its id and first character.
constexpr ImGuiID kCount = 0xC401CE00, kWanted = 0xC401CE01, kFrame = 0xC401CE02;
constexpr ImGuiID kIds = 0xC4100000, kInitials = 0xC4200000;

constexpr int kPageOfChoices = 10;  // entries

ImGuiID nth(ImGuiID first, int index) { return first + static_cast<ImGuiID>(index); }

int lower(unsigned character) {
  return static_cast<int>(character < 128 ? std::tolower(static_cast<int>(character)) : character);
}

int initial_of(const char* title) {
  unsigned character = 0;
  ImTextCharFromUtf8(&character, title, nullptr);
  return lower(character);
}

/// By how many entries the keys that went down walk.
int steps_walked() {
  constexpr int kToTheEnd = 1 << 20;
  constexpr std::pair<Key, int> kWalks[] = {{Key::up, -1},
                                            {Key::down, 1},
                                            {Key::page_up, -kPageOfChoices},
                                            {Key::page_down, kPageOfChoices},
                                            {Key::home, -kToTheEnd},
                                            {Key::end, kToTheEnd}};
  for (const auto& [key, by] : kWalks)
    if (ImGui::IsKeyPressed(static_cast<int>(key), true)) return by;
  return 0;
}

/// The next entry after `focused` whose title begins with what was typed, round the end.
std::optional<int> typed_entry(const ImGuiStorage& memory, int focused, int count) {
  const ImVector<ImWchar>& typed = ImGui::GetIO().InputQueueCharacters;
  if (typed.empty()) return std::nullopt;
  for (int k = 1; k <= count; ++k) {
    const int index = (focused + k) % count;
    if (memory.GetInt(nth(kInitials, index)) == lower(typed.back())) return index;
  }
  return std::nullopt;
}

}  // namespace

bool choice_entry(const char* title, bool is_chosen) {
  const bool is_taken = ImGui::Selectable(title, is_chosen);
  if (is_chosen) ImGui::SetItemDefaultFocus();
  ImGuiWindow& list = *ImGui::GetCurrentWindow();
  ImGuiStorage& memory = list.StateStorage;
  const bool is_first = memory.GetInt(kFrame) != ImGui::GetFrameCount();
  const int index = is_first ? 0 : memory.GetInt(kCount);
  memory.SetInt(kFrame, ImGui::GetFrameCount());
  const ImGuiID id = ImGui::GetItemID();
  memory.SetInt(kCount, index + 1);
  memory.SetInt(nth(kIds, index), static_cast<int>(id));
  memory.SetInt(nth(kInitials, index), initial_of(title));
  if (memory.GetInt(kWanted) == static_cast<int>(id)) {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    ImGui::SetNavID(id, g.NavLayer, list.DC.NavFocusScopeIdCurrent,
                    ImGui::WindowRectAbsToRel(&list, g.LastItemData.NavRect));
    ImGui::ScrollToItem(ImGuiScrollFlags_KeepVisibleEdgeY);
    memory.SetInt(kWanted, 0);
  }
  return is_taken;
}

bool walk_choices(ImGuiWindow& list) {
  ImGuiStorage& memory = list.StateStorage;
  const int count = memory.GetInt(kCount);
  if (count == 0) return false;
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const auto focus = static_cast<int>(g.NavId);
  int focused = 0;
  for (int i = 0; i < count; ++i)
    if (memory.GetInt(nth(kIds, i)) == focus) focused = i;
  std::optional<int> wanted = typed_entry(memory, focused, count);
  if (const int by = steps_walked(); by != 0) wanted = std::clamp(focused + by, 0, count - 1);
  if (!wanted) return false;
  if (g.NavWindow != &list) ImGui::FocusWindow(&list);
  memory.SetInt(kWanted, memory.GetInt(nth(kIds, *wanted)));
  return true;
}

}  // namespace foldless
