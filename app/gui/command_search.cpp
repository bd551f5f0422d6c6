// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/command_search.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <vector>

#include "app/editor/commands.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/directory.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

std::string words_of(const Command& command) {
  return std::string(command.menu) + ": " + std::string(command.title);
}

std::vector<const Command*> matches(const std::string& text) {
  std::vector<const Command*> found;
  for (const Command& command : commands())
    if (matches_filter(words_of(command), text)) found.push_back(&command);
  // Letters in one piece before letters that are scattered.
  std::stable_partition(found.begin(), found.end(), [&text](const Command* command) {
    const std::string words = words_of(*command);
    const auto equal = [](char a, char b) { return lower_case(a) == lower_case(b); };
    return text.empty() ||
           std::search(words.begin(), words.end(), text.begin(), text.end(), equal) != words.end();
  });
  return found;
}

void draw_shortcut(const Command& command, const Look& look) {
  const std::string shortcut = shortcut_words(command);
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

void CommandSearch::draw(Editor& editor, const Look& look) {
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
  ImGui::BeginChild("rows");
  draw_rows(editor, is_taken, look);
  ImGui::EndChild();
  ImGui::EndPopup();
}

void CommandSearch::draw_rows(Editor& editor, bool is_taken, const Look& look) {
  const auto found = matches(text_);
  if (found.empty()) return dim_text("No command has these letters.", look);
  const auto walked = walk_list(selected_, found.size(), !text_.empty());
  selected_ = std::min(walked.value_or(selected_), found.size() - 1);
  const Command* chosen = is_taken ? found[selected_] : nullptr;
  for (std::size_t row = 0; row < found.size(); ++row) {
    const Command& command = *found[row];
    ImGui::BeginDisabled(!is_available(command, editor));
    if (ImGui::Selectable(words_of(command).c_str(), row == selected_,
                          ImGuiSelectableFlags_DontClosePopups))
      chosen = &command;
    if (row == selected_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    draw_shortcut(command, look);
    ImGui::EndDisabled();
  }
  if (!chosen || !is_available(*chosen, editor)) return;
  ImGui::CloseCurrentPopup();
  editor.run_command(chosen->name);
}

}  // namespace foldless
