// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "app/editor/convergence.h"
#include "app/editor/race_table.h"
#include "app/gui/race_panel.h"
#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

void text_cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

void name_cell(const Race& race, std::size_t index, const Look& look) {
  ImGui::TableNextColumn();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float middle = corner.y + ImGui::GetTextLineHeight() / 2;
  draw_line_sample(curve_of_lane(race, index, *look.palette), {corner.x, middle},
                   {corner.x + look.px(22), middle}, look.px(1.6F));
  ImGui::Dummy({look.px(22), 1});
  ImGui::SameLine();
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::TextUnformatted(lane_name(race, index, room).c_str());
  tooltip(race.lanes()[index]->title(), look);
}

void draw_row(const Race& race, std::size_t index, std::optional<int> place, const Look& look) {
  const RaceLane& lane = *race.lanes()[index];
  const Iteration record = lane.record() ? *lane.record() : Iteration{};
  ImGui::TableNextRow();
  text_cell(place ? std::to_string(*place) + "." : "–");
  name_cell(race, index, look);
  text_cell(short_number(lane.proof().max_conformal_distortion, 3) + " / " +
            short_number(record.mean_conformal_distortion, 3));
  text_cell(short_number(record.handle_error_squared, 2));
  text_cell(std::string(convergence_letter(lane)));
  text_cell(std::to_string(record.factorizations) + "/" + std::to_string(record.updates));
  ImGui::TableNextColumn();
  ImGui::Text("%.3f", record.seconds);
}

/// A column with its explanation under the mouse.
struct Column {
  const char* title;
  const char* tip;
};

constexpr std::array<Column, 7> kColumns{{
    {"", "Place: of the lanes that reached their targets without a fold, by processor time."},
    {"Lane", ""},
    {"M/A", "Largest and mean conformal distortion σ₁/σ₂."},
    {"‖P‖²", "Squared distance of the handles to their targets."},
    {"CI", "How it ended: G by the gradient, S by the step, M not converged."},
    {"H/U", "Factorizations of the Hessian and updates of the vertices."},
    {"s", "Seconds of processor time."},
}};

void draw_column_titles(const Look& look) {
  // The numbers get the room that they need, the names what is left.
  for (const Column& column : kColumns)
    ImGui::TableSetupColumn(column.title, &column == &kColumns[1]
                                              ? ImGuiTableColumnFlags_WidthStretch
                                              : ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const Column& column : kColumns) {
    ImGui::TableNextColumn();
    ImGui::TableHeader(column.title);
    tooltip(column.tip, look);
  }
}

void draw_exports(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  if (ImGui::Button("Table…")) editor.run_command("file.export_table");
  tooltip("Writes this table to a file, as the paper's Table 1.", look);
  ImGui::SameLine();
  if (ImGui::Button("CSV…")) editor.run_command("file.export_csv");
  tooltip("Writes every iteration of every lane to a file.", look);
  ImGui::SameLine();
  if (ImGui::Button("SVG…")) editor.run_command("file.export_svg");
  tooltip("Draws the curves into a file, as the paper's Figure 13.", look);
  ImGui::SameLine();
  ImGui::Checkbox("Over time", &context.state.has_time_axis);
  tooltip("Plots over seconds of processor time in place of iterations.", look);
}

void draw_table(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  ImGui::PushFont(look.fonts.small);
  if (ImGui::BeginTable("table", static_cast<int>(kColumns.size()),
                        ImGuiTableFlags_BordersInnerH | ImGuiTableFlags_NoSavedSettings)) {
    draw_column_titles(look);
    const auto places = race_places(editor.race());
    for (std::size_t i = 0; i < places.size(); ++i) draw_row(editor.race(), i, places[i], look);
    ImGui::EndTable();
  }
  ImGui::PopFont();
  ImGui::Spacing();
  draw_exports(editor, context);
}

void draw_one_plot(const ConvergenceSeries& series, Editor& editor, const PanelContext& context,
                   const ImVec2& size) {
  const Look& look = context.look;
  Race& race = editor.race();
  std::vector<PlotCurve> curves;
  for (std::size_t i = 0; i < race.lanes().size(); ++i) {
    curves.push_back(curve_of_lane(race, i, *look.palette));
    curves.back().values = values_of(series, race.lanes()[i]->records(), race.furthest());
    if (context.state.has_time_axis)
      curves.back().positions = times_of(race.lanes()[i]->records(), race.furthest());
  }
  std::optional<std::size_t> cursor;
  if (race.tick() > 0) cursor = race.tick() - 1;
  const auto chosen = draw_plot({.id = series.name.data(),
                                 .title = series.title.data(),
                                 .curves = curves,
                                 .is_logarithmic = series.is_logarithmic,
                                 .cursor = cursor,
                                 .size = size,
                                 .font = look.fonts.small,
                                 .zoom = &context.state.plot_zoom,
                                 .unit = context.state.has_time_axis ? " s" : ""},
                                *look.palette);
  if (chosen) race.scrub(*chosen + 1);
}

/// Four plots, two a row where they have room.
void draw_plots(Editor& editor, const PanelContext& context, const ImVec2& room) {
  const Look& look = context.look;
  static constexpr std::array<std::string_view, 4> kShown{"energy", "gradient", "residual",
                                                          "distortion"};
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const ImVec2 size{(room.x - gap) / 2,
                    std::max(look.px(72), (room.y - ImGui::GetStyle().ItemSpacing.y) / 2)};
  std::size_t drawn = 0;
  for (const ConvergenceSeries& series : convergence_series()) {
    if (std::ranges::find(kShown, series.name) == kShown.end()) continue;
    if (drawn++ % 2 == 1) ImGui::SameLine();
    draw_one_plot(series, editor, context, size);
  }
}

}  // namespace

void draw_race_results(Editor& editor, const PanelContext& context, const Rectangle& place) {
  const Look& look = context.look;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  if (ImGui::Begin("##race results", nullptr,
                   ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                       ImGuiWindowFlags_NoBringToFrontOnFocus)) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (place.width > look.px(820)) {
      const float plots = std::round(room.x - std::max(room.x * 0.42F, look.px(480)));
      ImGui::BeginChild("plots", {plots, 0});
      draw_plots(editor, context, ImGui::GetContentRegionAvail());
      ImGui::EndChild();
      ImGui::SameLine(0, look.px(16));
      begin_controls("table", {0, 0}, look);
      draw_table(editor, context);
      ImGui::EndChild();
    } else {
      draw_table(editor, context);
      draw_plots(editor, context, {room.x, 0});
    }
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace foldless
