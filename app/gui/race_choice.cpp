// SPDX-License-Identifier: GPL-3.0-or-later
// What the lanes of a race are.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/gui/choice_list.h"
#include "app/gui/race_panel.h"
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

void choose_method(Race& race, std::size_t lane) {
  for (const MethodRow& row : methods())
    if (choice_entry(row.title.data(), race.setup().methods[lane] == row.name)) {
      RaceSetup changed = race.setup();
      changed.methods[lane] = row.name;
      return race.set_setup(changed);
    }
}

void choose_energy(Race& race, std::size_t lane) {
  for (const Density& density : densities())
    if (choice_entry(density.title.data(), race.setup().energies[lane] == &density)) {
      RaceSetup changed = race.setup();
      changed.energies[lane] = &density;
      return race.set_setup(changed);
    }
}

/// What is no number is chosen from a list.
void choose_from_list(Race& race, std::size_t lane, const RoomForChoice& room) {
  const float arrow = room.is_narrow ? 0 : ImGui::GetFrameHeight();
  const float words = room.width - arrow - 2 * ImGui::GetStyle().FramePadding.x;
  if (!begin_combo("##choice", lane_name(race, lane, words),
                   room.is_narrow ? ImGuiComboFlags_NoArrowButton : 0))
    return;
  if (race.setup().varies_energy())
    choose_energy(race, lane);
  else
    choose_method(race, lane);
  ImGui::EndCombo();
}

std::string choice_tip(const Race& race, std::size_t lane) {
  if (const ParameterRow* varied = race.setup().varied)
    return "The lane's value of “" + std::string(varied->title) +
           "”. Enter starts all lanes again.";
  return race.lanes()[lane]->title() + (race.setup().varies_energy()
                                            ? ". Another energy starts all lanes again."
                                            : ". Another method starts all lanes again.");
}

void choose_value(Race& race, std::size_t lane) {
  const ParameterRow& row = *race.setup().varied;
  double value = race.setup().values[lane];
  ImGui::InputDouble("##value", &value, 0, 0, "%.6g");
  if (!ImGui::IsItemDeactivatedAfterEdit() || std::isnan(value)) return;
  RaceSetup changed = race.setup();
  changed.values[lane] = std::clamp(value, row.minimum, row.maximum);
  race.set_setup(changed);
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

void draw_lane_choice(Race& race, std::size_t lane, const Look& look) {
  RoomForChoice room;
  room.is_narrow = ImGui::GetWindowSize().x < look.px(kNarrowLane);
  draw_sample(race, lane, room.is_narrow, look);
  const float use = look.px(46);
  room.width = std::max(look.px(40), ImGui::GetContentRegionAvail().x - use);
  ImGui::SetNextItemWidth(room.width);
  if (race.setup().varied)
    choose_value(race, lane);
  else
    choose_from_list(race, lane, room);
  tooltip(choice_tip(race, lane), look);
}

}  // namespace foldless
