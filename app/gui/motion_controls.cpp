// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "app/gui/choice_list.h"
#include "app/gui/command_button.h"
#include "app/gui/easing_curve.h"
#include "app/gui/panels.h"
#include "app/gui/time_line.h"
#include "app/gui/widgets.h"

namespace foldless {

std::string title_of(const NamedEasing& easing) {
  std::string words(easing.name);
  words[0] = static_cast<char>(words[0] - 'a' + 'A');
  return words;
}

namespace {

/// The easing that all selected keys have; nothing where they differ.
std::optional<Easing> easing_of(const Motion& motion) {
  std::optional<Easing> common;
  bool differs = false;
  const auto look_at = [&](const auto& track, int handle, KeyedProperty property) {
    for (const auto& key : track) {
      if (!motion.keys().selected().contains({handle, property, key.frame})) continue;
      differs = differs || (common && !(*common == key.easing));
      common = key.easing;
    }
  };
  for (const HandleTracks& tracks : motion.animation().tracks) {
    look_at(tracks.position, tracks.handle, KeyedProperty::position);
    look_at(tracks.angle, tracks.handle, KeyedProperty::angle);
    look_at(tracks.depth, tracks.handle, KeyedProperty::depth);
    look_at(tracks.weight, tracks.handle, KeyedProperty::weight);
  }
  return differs ? std::nullopt : common;
}

/// The curve between ends that are pulled, which are fields too, for those that have no name.
void draw_curve(const Easing& easing, Motion& motion, const PanelContext& context) {
  ImGui::TextUnformatted("Pull the ends of the curve:");
  const auto pulled = draw_easing_curve(easing, context.state.time_line.pulled_curve, context.look);
  if (pulled && !(*pulled == easing)) motion.keys().set_easing(*pulled);
  std::array<float, 4> values{
      static_cast<float>(easing.first.x()), static_cast<float>(easing.first.y()),
      static_cast<float>(easing.second.x()), static_cast<float>(easing.second.y())};
  ImGui::TextUnformatted("Curve: x\u2081 y\u2081 x\u2082 y\u2082");
  if (!ImGui::InputFloat4("##curve", values.data(), "%.3g", ImGuiInputTextFlags_EnterReturnsTrue))
    return;
  Easing curve;
  curve.first = {std::clamp(values[0], 0.0F, 1.0F), values[1]};
  curve.second = {std::clamp(values[2], 0.0F, 1.0F), values[3]};
  motion.keys().set_easing(curve);
}

void draw_easing(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  Motion& motion = editor.motion();
  ImGui::BeginDisabled(motion.keys().selected().empty());
  const auto easing = easing_of(motion);
  std::string words = "Easing";
  if (easing) words = "Own curve";
  for (const NamedEasing& row : easings())
    if (easing == row.easing) words = title_of(row);
  ImGui::SetNextItemWidth(look.px(96));
  if (begin_combo("##easing", words, ImGuiComboFlags_HeightLargest)) {
    for (const NamedEasing& row : easings())
      if (choice_entry(title_of(row).c_str(), easing == row.easing))
        motion.keys().set_easing(row.easing);
    ImGui::Separator();
    if (easing) draw_curve(*easing, motion, context);
    ImGui::EndCombo();
  }
  ImGui::EndDisabled();
  tooltip("How the selected keys go on to the next ones.", look);
}

void draw_length(Editor& editor, const Look& look) {
  Motion& motion = editor.motion();
  Cycle cycle = motion.animation().cycle;
  int frames = cycle.frames;
  ImGui::SetNextItemWidth(look.px(56));
  if (ImGui::InputInt("##frames", &frames, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue)) {
    cycle.frames = frames;
    motion.keys().set_cycle(cycle);
  }
  tooltip("How many frames the animation has.", look);
  ImGui::SameLine(0, look.px(4));
  ImGui::TextUnformatted("frames");
  ImGui::SameLine();
  double fps = motion.animation().fps;
  ImGui::SetNextItemWidth(look.px(48));
  if (ImGui::InputDouble("##fps", &fps, 0, 0, "%.4g", ImGuiInputTextFlags_EnterReturnsTrue))
    motion.keys().set_fps(fps);
  tooltip("Frames a second: 12, 24, 25, 30, 50, 60 or any other number.", look);
  ImGui::SameLine(0, look.px(4));
  ImGui::TextUnformatted("fps");
  ImGui::SameLine();
  bool loops = cycle.loops;
  if (ImGui::Checkbox("Loop", &loops)) {
    cycle.loops = loops;
    motion.keys().set_cycle(cycle);
  }
  tooltip("The last key goes over into the first, and the shape comes back.", look);
}

}  // namespace

void draw_motion_controls(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  command_button("motion.record", Icon::record, editor, look);
  ImGui::SameLine();
  command_button("motion.key", Icon::key, editor, look);
  ImGui::SameLine();
  command_button("motion.onion_skin", Icon::onion_skin, editor, look);
  ImGui::SameLine();
  draw_easing(editor, context);
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x > look.px(230)) draw_length(editor, look);
}

}  // namespace foldless
