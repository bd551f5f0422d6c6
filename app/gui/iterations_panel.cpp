// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "app/editor/convergence.h"
#include "app/gui/panels.h"
#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

void draw_row(std::size_t index, Editor& editor, const PanelContext& context) {
  const Iteration& record = editor.playback().iterations()[index];
  const Look& look = context.look;
  const bool is_last = index + 1 == editor.playback().iterations().size();
  const bool is_shown =
      editor.playback().scrubbed() ? *editor.playback().scrubbed() == index : is_last;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(index));
  if (ImGui::Selectable("##row", is_shown, ImGuiSelectableFlags_SpanAllColumns) &&
      editor.playback().can_scrub())
    editor.playback().scrub(index);
  ImGui::PopID();
  ImGui::SameLine(0, 0);
  ImGui::Text("%zu", index + 1);
  ImGui::TableNextColumn();
  const std::string phase =
      elided(std::string(name_of(record.phase)), ImGui::GetContentRegionAvail().x);
  ImGui::TextColored(look.palette->dim, "%s", phase.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(short_number(record.energy, 3).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(short_number(record.handle_error_squared, 2).c_str());
  ImGui::TableNextColumn();
  if (const int changed = remeshed_edges(editor.playback().iterations(), index); changed != 0)
    ImGui::TextColored(look.palette->accent, "%d", changed);
}

/// A column that is as wide as the longest of its numbers.
void number_column(const char* title, const char* longest) {
  const float width = std::max(ImGui::CalcTextSize(longest).x, ImGui::CalcTextSize(title).x);
  ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthFixed, width);
}

void draw_header() {
  ImGui::TableSetupScrollFreeze(0, 1);
  number_column("#", "8888");
  ImGui::TableSetupColumn("Phase", ImGuiTableColumnFlags_WidthStretch);
  number_column("E", "8.88e-88");
  number_column("‖P‖²", "8.8e-88");
  number_column("Edges", "8888");
  ImGui::TableHeadersRow();
}

}  // namespace

void draw_iterations_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const std::size_t count = editor.playback().iterations().size();
  if (count == 0) return dim_text("None since the last edit.", look);
  const float height = std::max(ImGui::GetContentRegionAvail().y - look.px(14), look.px(96));
  ImGui::PushFont(look.fonts.small);
  if (ImGui::BeginTable("iterations", 5, ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH,
                        {0, height})) {
    draw_header();
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count));
    while (clipper.Step())
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        draw_row(static_cast<std::size_t>(i), editor, context);
    // Follows the solver as long as the end of the list was in sight.
    if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - look.px(4)) ImGui::SetScrollHereY(1);
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

}  // namespace foldless
