// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/command_search.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <vector>

#include "app/gui/dialog_keys.h"
#include "app/gui/directory.h"
#include "app/gui/interface_commands.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// Letters in one piece before letters that are scattered.
void drop_others(std::vector<Action>& actions, const std::string& text) {
  std::erase_if(actions, [&](const Action& action) { return !matches_filter(action.words, text); });
  const auto equal = [](char a, char b) { return lower_case(a) == lower_case(b); };
  std::stable_partition(actions.begin(), actions.end(), [&](const Action& action) {
    return text.empty() || std::search(action.words.begin(), action.words.end(), text.begin(),
                                       text.end(), equal) != action.words.end();
  });
}

void draw_shortcut(const std::string& shortcut, const Look& look) {
  if (shortcut.empty()) return;
  const float width = ImGui::CalcTextSize(shortcut.c_str()).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width - look.px(4));
  ImGui::TextColored(look.palette->dim, "%s", shortcut.c_str());
}

}  // namespace

void CommandSearch::open() {
  opens_now_ = true;
  text_.clear();
  selected_ = 0;
}

void CommandSearch::draw(Editor& editor, UiState& state, const Look& look) {
  if (opens_now_) ImGui::OpenPopup("##command search");
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float width = std::min(look.px(520), display.x * 0.9F);
  ImGui::SetNextWindowPos({(display.x - width) / 2, look.px(72)});
  ImGui::SetNextWindowSize({width, std::min(look.px(380), display.y * 0.7F)});
  if (!ImGui::BeginPopup("##command search", ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove))
    return;
  if (opens_now_) ImGui::SetKeyboardFocusHere();
  opens_now_ = false;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##search", "What would you like to do?", &text_)) selected_ = 0;
  const bool is_taken = dialog_keys(TextKeys::dialog).takes;
  begin_rows({0, 0}, look);
  draw_rows(all_actions(editor, state), is_taken, look);
  ImGui::EndChild();
  ImGui::EndPopup();
}

void CommandSearch::draw_rows(std::vector<Action> actions, bool is_taken, const Look& look) {
  drop_others(actions, text_);
  if (actions.empty()) return dim_text("Nothing has these letters.", look);
  const auto walked = walk_list(selected_, actions.size(), !text_.empty());
  selected_ = std::min(walked.value_or(selected_), actions.size() - 1);
  const Action* chosen = is_taken ? &actions[selected_] : nullptr;
  for (std::size_t row = 0; row < actions.size(); ++row) {
    const Action& action = actions[row];
    ImGui::PushID(static_cast<int>(row));
    ImGui::BeginDisabled(!action.is_available);
    if (ImGui::Selectable(action.words.c_str(), row == selected_,
                          ImGuiSelectableFlags_DontClosePopups))
      chosen = &action;
    if (row == selected_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    draw_shortcut(action.shortcut, look);
    ImGui::EndDisabled();
    ImGui::PopID();
  }
  if (!chosen || !chosen->is_available) return;
  ImGui::CloseCurrentPopup();
  chosen->run();
}

}  // namespace foldless
