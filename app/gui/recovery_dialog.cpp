// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/recovery_dialog.h"

#include <string>

#include "app/gui/dialog_focus.h"
#include "app/gui/dialog_keys.h"
#include "app/gui/side_dialog.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

std::string name_of(const Origin& origin) {
  if (!origin.path.empty()) return origin.path.filename().string();
  return origin.name.empty() ? "Untitled" : origin.name;
}

void draw_row(Recovery& recovery, std::size_t index, const Look& look) {
  ImGui::PushID(static_cast<int>(index));
  const Origin origin = recovery.origin(index);
  const bool is_selected = index == recovery.selected();
  const float height = 2 * ImGui::GetTextLineHeightWithSpacing();
  const ImVec2 start = ImGui::GetCursorPos();
  if (ImGui::Selectable("##row", is_selected, 0, {0, height}) && !is_selected)
    recovery.select(index);
  const ImVec2 end = ImGui::GetCursorPos();
  tooltip(origin.path.empty() ? "Never saved." : origin.path.string(), look);
  ImGui::SetCursorPos({start.x + look.px(8), start.y});
  ImGui::TextUnformatted(name_of(origin).c_str());
  ImGui::SetCursorPosX(start.x + look.px(8));
  dim_text(recovery.time(index) + (origin.path.empty() ? ", never saved" : ""), look);
  ImGui::SetCursorPos(end);
  ImGui::PopID();
}

void draw_rows(Recovery& recovery, const Look& look) {
  const std::size_t selected = recovery.selected();
  const auto walked = walk_list(selected, recovery.count());
  if (walked && *walked != selected) recovery.select(*walked);
  begin_list_rows();
  for (std::size_t i = 0; i < recovery.count(); ++i) draw_row(recovery, i, look);
  end_list_rows();
}

void draw_problem(const Recovery& recovery, const Look& look) {
  const bool has_work = recovery.problem().empty();
  if (has_work && recovery.unread().empty()) return;
  ImGui::Spacing();
  ImGui::PushStyleColor(ImGuiCol_Text, look.palette->warning);
  ImGui::TextWrapped("%s", (has_work ? recovery.unread() : recovery.problem()).c_str());
  if (has_work) ImGui::TextWrapped("This is the newest that can be read; the rest is kept.");
  ImGui::PopStyleColor();
}

/// Nothing brings it back, so it is asked first.
void draw_discard_question(Recovery& recovery, const Look& look) {
  if (!begin_dialog("##discard", look)) return;
  title_text("Discard it for good?", look);
  const std::size_t selected = recovery.selected();
  dim_text(name_of(recovery.origin(selected)) + ", " + recovery.time(selected), look);
  ImGui::Spacing();
  const bool keeps = main_button("Keep it", look);
  ImGui::SameLine();
  const bool discards = ImGui::Button("Discard");
  if (discards) recovery.discard();
  const DialogKeys keys = dialog_keys();
  if (keeps || discards || keys.takes || keys.leaves) ImGui::CloseCurrentPopup();
  end_dialog();
}

void draw_buttons(Editor& editor, const Look& look) {
  Recovery& recovery = editor.files().recovery();
  ImGui::BeginDisabled(!recovery.work());
  const bool restores = main_button("Restore", look);
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Discard…")) ImGui::OpenPopup("##discard");
  ImGui::SameLine();
  const bool leaves = ImGui::Button("Later");
  tooltip("It is offered again the next time, and by Recover unsaved work in the File menu.", look);
  draw_discard_question(recovery, look);
  const DialogKeys keys = dialog_keys();
  if (restores || (recovery.work() && keys.takes)) return editor.files().recover();
  if (leaves || keys.leaves) recovery.close();
}

}  // namespace

void draw_recovery_dialog(Editor& editor, const PanelContext& context) {
  Recovery& recovery = editor.files().recovery();
  const bool is_open = recovery.is_open() && !editor.files().question();
  if (!begin_side_dialog("##recovery", is_open, context)) return;
  const Look& look = context.look;
  if (is_open) {
    title_text("Recover unsaved work", look);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted("Foldless ended before this was saved.");
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    // In a low window the rows scroll, the buttons stay.
    begin_rows({0, -ImGui::GetFrameHeightWithSpacing()}, look);
    draw_rows(recovery, look);
    draw_problem(recovery, look);
    ImGui::EndChild();
    draw_buttons(editor, look);
  }
  end_side_dialog();
}

}  // namespace foldless
