// SPDX-License-Identifier: GPL-3.0-or-later
// What the lanes of a race are.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/gui/choice_list.h"
#include "app/gui/race_panel.h"
#include "app/gui/requests.h"
#include "app/gui/widgets.h"
#include "core/energy/densities.h"
#include "core/method/methods.h"

namespace foldless {
namespace {

/// Under this the line of a lane and the arrow of its list leave their room to the name. [design
/// pixels]
constexpr float kNarrowLane = 240;

/// For what a lane is.
struct RoomForChoice {
  float width = 0;
  bool is_narrow = false;
};

bool is_from_scene(const RaceSetup& setup, std::size_t lane) { return setup.scenes.contains(lane); }

/// A setup in which the lane takes nothing from a scene.
RaceSetup without_scene(RaceSetup setup, std::size_t lane) {
  setup.scenes.erase(lane);
  return setup;
}

void choose_method(Race& race, std::size_t lane) {
  const bool has_scene = is_from_scene(race.setup(), lane);
  for (const MethodRow& row : methods())
    if (choice_entry(row.title.data(), !has_scene && race.setup().methods[lane] == row.name)) {
      RaceSetup changed = without_scene(race.setup(), lane);
      changed.methods[lane] = row.name;
      return race.set_setup(changed);
    }
}

void choose_energy(Race& race, std::size_t lane) {
  const bool has_scene = is_from_scene(race.setup(), lane);
  for (const Density& density : densities())
    if (choice_entry(density.title.data(), !has_scene && race.setup().energies[lane] == &density)) {
      RaceSetup changed = without_scene(race.setup(), lane);
      changed.energies[lane] = &density;
      return race.set_setup(changed);
    }
}

/// Values are typed, so the list only leads back to that.
void choose_to_type(Race& race, std::size_t lane) {
  const std::string words = "A value of " + std::string(race.setup().varied->title);
  const bool has_scene = is_from_scene(race.setup(), lane);
  if (choice_entry(words.c_str(), !has_scene) && has_scene)
    race.set_setup(without_scene(race.setup(), lane));
}

void draw_choices(Editor& editor, std::size_t lane, UiState& state) {
  Race& race = editor.race();
  if (race.setup().varied)
    choose_to_type(race, lane);
  else if (race.setup().varies_energy())
    choose_energy(race, lane);
  else
    choose_method(race, lane);
  ImGui::Separator();
  if (choice_entry("From a scene…", is_from_scene(race.setup(), lane)))
    ask_for_lane_scene(lane, editor, state);
  ImGui::EndCombo();
}

/// What is no number is chosen from a list.
void choose_from_list(Editor& editor, std::size_t lane, const RoomForChoice& room, UiState& state) {
  const float arrow = room.is_narrow ? 0 : ImGui::GetFrameHeight();
  const float words = room.width - arrow - 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(room.width);
  if (begin_combo("##choice", lane_name(editor.race(), lane, words),
                  room.is_narrow ? ImGuiComboFlags_NoArrowButton : 0))
    draw_choices(editor, lane, state);
}

std::string choice_tip(const Race& race, std::size_t lane) {
  if (is_from_scene(race.setup(), lane))
    return "Method, energy and numbers of " + race.setup().scenes.at(lane).file.string() +
           ". Another choice starts all lanes again.";
  if (race.setup().varied) return "Takes all that the lane is run with from a scene instead.";
  return race.lanes()[lane]->title() + (race.setup().varies_energy()
                                            ? ". Another energy starts all lanes again."
                                            : ". Another method starts all lanes again.");
}

void choose_value(Race& race, std::size_t lane, const Look& look) {
  const ParameterRow& row = *race.setup().varied;
  double value = race.setup().values[lane];
  ImGui::InputDouble("##value", &value, 0, 0, "%.6g");
  const bool is_entered = ImGui::IsItemDeactivatedAfterEdit() && !std::isnan(value);
  tooltip("The lane's value of “" + std::string(row.title) + "”. Enter starts all lanes again.",
          look);
  if (!is_entered) return;
  RaceSetup changed = race.setup();
  changed.values[lane] = std::clamp(value, row.minimum, row.maximum);
  race.set_setup(changed);
}

/// A field, and the list behind it.
void choose_value_or_scene(Editor& editor, std::size_t lane, const RoomForChoice& room,
                           const PanelContext& context) {
  ImGui::SetNextItemWidth(room.width - ImGui::GetFrameHeight());
  choose_value(editor.race(), lane, context.look);
  ImGui::SameLine(0, 0);
  if (ImGui::BeginCombo("##choice", "", ImGuiComboFlags_NoPreview))
    draw_choices(editor, lane, context.state);
}

/// The lane's line, as in the plots; along its top where there is no room before the choice.
void draw_sample(const Race& race, std::size_t lane, bool is_narrow, const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (is_narrow) {
    const float y = ImGui::GetWindowPos().y + look.px(3);
    draw_line_sample(curve_of_lane(race, lane, *look.palette), {corner.x, y},
                     {corner.x + ImGui::GetContentRegionAvail().x, y}, look.px(2));
    return;
  }
  const float middle = corner.y + ImGui::GetFrameHeight() / 2;
  draw_line_sample(curve_of_lane(race, lane, *look.palette), {corner.x, middle},
                   {corner.x + look.px(28), middle}, look.px(2));
  ImGui::Dummy({look.px(28), ImGui::GetFrameHeight()});
  ImGui::SameLine();
}

}  // namespace

void draw_lane_choice(Editor& editor, std::size_t lane, const PanelContext& context) {
  const Look& look = context.look;
  const RaceSetup& setup = editor.race().setup();
  RoomForChoice room;
  room.is_narrow = ImGui::GetWindowSize().x < look.px(kNarrowLane);
  draw_sample(editor.race(), lane, room.is_narrow, look);
  const float use = look.px(46);
  room.width = std::max(look.px(40), ImGui::GetContentRegionAvail().x - use);
  if (setup.varied && !is_from_scene(setup, lane))
    choose_value_or_scene(editor, lane, room, context);
  else
    choose_from_list(editor, lane, room, context.state);
  tooltip(choice_tip(editor.race(), lane), look);
}

}  // namespace foldless
