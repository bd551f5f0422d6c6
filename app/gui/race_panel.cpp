// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/race_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "app/gui/choice_list.h"
#include "app/gui/race_layout.h"
#include "app/gui/short_text.h"
#include "app/gui/view_pane.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr ImGuiWindowFlags kRaceWindow = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                         ImGuiWindowFlags_NoBringToFrontOnFocus;

bool begin_part(const char* id, const Rectangle& place, const Look& look) {
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(10), look.px(7)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  const bool is_visible = ImGui::Begin(id, nullptr, kRaceWindow);
  ImGui::PopStyleVar(2);
  return is_visible;
}

void draw_varied(Race& race, const Look& look) {
  const RaceSetup& setup = race.setup();
  const ParameterRow* varied = setup.varied;
  const bool varies_method = !varied && !setup.varies_energy();
  const char* present = varies_method ? "Methods" : "Energies";
  ImGui::SetNextItemWidth(look.px(190));
  if (begin_combo("##varied", varied ? varied->title.data() : present)) {
    if (choice_entry("Methods", varies_method)) race.set_setup(method_race(race.document()));
    if (choice_entry("Energies", setup.varies_energy()))
      race.set_setup(energy_race(race.document()));
    for (const ParameterRow& row : parameter_rows())
      if (choice_entry(row.title.data(), varied == &row))
        race.set_setup(parameter_race(row, race.document()));
    ImGui::EndCombo();
  }
  tooltip("What the lanes differ in: the method, the energy, or one number of the solver.", look);
}

void draw_lane_count(Race& race, const Look& look) {
  const std::size_t count = race.lanes().size();
  ImGui::BeginDisabled(count <= kFewestLanes);
  if (ImGui::Button("–##fewer")) race.set_setup(without_lane(race.setup()));
  ImGui::EndDisabled();
  tooltip("One lane less.", look);
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%zu lanes", count);
  ImGui::SameLine();
  ImGui::BeginDisabled(count >= kMostLanes);
  if (ImGui::Button("+##more")) race.set_setup(with_lane(race.setup()));
  ImGui::EndDisabled();
  tooltip("One lane more.", look);
}

void draw_start(Race& race, const Look& look) {
  static constexpr std::array kStarts{"From the mesh at rest", "From the present mesh"};
  const std::size_t present = race.setup().starts_at_rest ? 0 : 1;
  ImGui::SetNextItemWidth(look.px(176));
  if (begin_combo("##start", kStarts[present])) {
    for (std::size_t i = 0; i < kStarts.size(); ++i)
      if (choice_entry(kStarts[i], i == present) && i != present) {
        RaceSetup setup = race.setup();
        setup.starts_at_rest = i == 0;
        race.set_setup(setup);
      }
    ImGui::EndCombo();
  }
  tooltip("The mesh that every lane starts from. The targets are the same in any case.", look);
}

/// Puts the next item on this line, or on the next when it has no room here.
void same_line_if_fits(float width) {
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

void draw_setup(Editor& editor, const PanelContext& context, const Rectangle& place) {
  const Look& look = context.look;
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->bar);
  if (begin_part("##race setup", place, look)) {
    Race& race = editor.race();
    draw_varied(race, look);
    ImGui::SameLine();
    draw_lane_count(race, look);
    same_line_if_fits(look.px(180));
    draw_start(race, look);
    same_line_if_fits(look.px(60));
    if (ImGui::Button("Again")) editor.run_command("race.restart");
    tooltip("Starts all lanes again (Shift+M).", look);
    same_line_if_fits(look.px(60));
    if (main_button("Close", look)) editor.run_command("race.toggle");
    tooltip("Back to the document, which the race has not touched (Esc).", look);
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

/// True when the user wants what the lane shows.
bool draw_use_button(const RaceLane& lane, const Look& look) {
  ImGui::SameLine();
  ImGui::BeginDisabled(lane.proof().folds());
  const bool is_pressed = ImGui::Button("Use");
  ImGui::EndDisabled();
  tooltip(!lane.proof().folds()
              ? "Takes this mesh, and how it was made, into the document: one undo step."
              : "This map folds; the editor keeps to maps that do not.",
          look);
  return is_pressed;
}

/// What matters most stands first: in a narrow lane the rest is left out.
std::string numbers_of(const RaceLane& lane, float width) {
  const Iteration record = lane.record() ? *lane.record() : Iteration{};
  const Proof& proof = lane.proof();
  const bool only_overlaps = !proof.folds() && !proof.holds();
  std::string text = only_overlaps
                         ? std::to_string(proof.overlapping_boundary_vertices) + " overlapping"
                         : std::to_string(proof.inverted) + " inverted";
  for (const std::string& more :
       {"‖P‖² " + short_number(record.handle_error_squared, 2),
        "H/U " + std::to_string(record.factorizations) + "/" + std::to_string(record.updates)}) {
    std::string longer = text;
    longer.append("  ·  ").append(more);
    if (ImGui::CalcTextSize(longer.c_str()).x > width) break;
    text = std::move(longer);
  }
  return text;
}

void draw_numbers(const RaceLane& lane, const Look& look) {
  const Proof& proof = lane.proof();
  ImGui::PushFont(look.fonts.small);
  const std::string text = numbers_of(lane, ImGui::GetContentRegionAvail().x);
  ImGui::PopFont();
  if (proof.holds()) return dim_text(text, look);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::PushFont(look.fonts.small);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddRectFilled(
      {low.x - look.px(4), low.y - look.px(1)},
      {low.x + size.x + look.px(4), low.y + size.y + look.px(1)}, packed(look.palette->caution),
      look.px(3));
  ImGui::TextColored(look.palette->on_caution, "%s", text.c_str());
  ImGui::PopFont();
  tooltip(fold_words(proof), look);
}

/// Returns whether the lane's mesh is to be used.
bool draw_head(Editor& editor, std::size_t index, const RaceLayout::Lane& place,
               const PanelContext& context) {
  const Look& look = context.look;
  const RaceLane& lane = *editor.race().lanes()[index];
  bool is_used = false;
  if (begin_part(("##race head " + std::to_string(index)).c_str(), place.head, look)) {
    draw_lane_choice(editor, index, context);
    // The choice may have started the race again, with other lanes.
    if (index < editor.race().lanes().size() && editor.race().lanes()[index].get() == &lane) {
      is_used = draw_use_button(lane, look);
      const bool is_good = lane.is_at_end() && lane.is_at_targets();
      const ImVec4& colour = is_good            ? look.palette->good
                             : lane.is_at_end() ? look.palette->warning
                                                : look.palette->text;
      const float room = ImGui::GetContentRegionAvail().x;
      ImGui::TextColored(colour, "%s", elided(lane.words(), room).c_str());
      tooltip(lane.words(), look);
      draw_numbers(lane, look);
    }
  }
  ImGui::End();
  return is_used;
}

void draw_view(Editor& editor, std::size_t index, const RaceLayout::Lane& place, const Look& look) {
  Race& race = editor.race();
  const PaneInput input =
      view_pane(("##race view " + std::to_string(index)).c_str(), place.view, race.canvas());
  if (input.camera) {
    race.set_camera(*input.camera);
    editor.messages().redraw();
  }
  if (index == 0) return;
  const float x = place.view.x - look.px(1);
  ImGui::GetBackgroundDrawList()->AddLine({x, place.head.y}, {x, place.view.y + place.view.height},
                                          packed(look.palette->border), look.px(2));
}

}  // namespace

std::string lane_name(const Race& race, std::size_t lane, float width) {
  const bool has_room = std::ranges::all_of(race.lanes(), [width](const auto& other) {
    return ImGui::CalcTextSize(other->title().c_str()).x <= width;
  });
  const RaceLane& named = *race.lanes()[lane];
  return has_room ? named.title() : elided(named.short_title(), width);
}

PlotCurve curve_of_lane(const Race& race, std::size_t lane, const Palette& palette) {
  PlotCurve curve;
  curve.name = race.lanes()[lane]->title();
  curve.colour = palette.series[lane % palette.series.size()];
  curve.style = static_cast<LineStyle>(lane % 4);
  return curve;
}

void draw_race_panel(Editor& editor, const PanelContext& context) {
  const RaceLayout layout =
      race_layout_for(context.layout.canvas, editor.race().lanes().size(), context.look.scale);
  std::optional<std::size_t> used;
  for (std::size_t i = 0; i < layout.lanes.size(); ++i) {
    draw_view(editor, i, layout.lanes[i], context.look);
    if (i < editor.race().lanes().size() && draw_head(editor, i, layout.lanes[i], context))
      used = i;
  }
  draw_race_results(editor, context, layout.results);
  draw_setup(editor, context, layout.setup);
  if (used) editor.use_race_lane(*used);
}

}  // namespace foldless
