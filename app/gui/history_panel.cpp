// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>

#include "app/gui/panels.h"
#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {

void draw_history_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const History& history = editor.draft().history();
  const auto& steps = history.steps();
  const float height = std::min(rows_height(steps.size(), look), look.px(200));
  std::optional<std::size_t> chosen;
  begin_rows({0, height}, look);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool is_undone = i > history.current();
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, is_undone ? look.palette->dim : look.palette->text);
    const std::string label = elided(steps[i].label, ImGui::GetContentRegionAvail().x);
    if (ImGui::Selectable(label.c_str(), i == history.current())) chosen = i;
    if (label != steps[i].label) tooltip(steps[i].label, look);
    ImGui::PopStyleColor();
    ImGui::PopID();
    if (i == history.current() && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
  }
  ImGui::EndChild();
  if (chosen) editor.draft().jump_to_step(*chosen);
}

}  // namespace foldless
