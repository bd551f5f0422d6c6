// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/gui/choice_list.h"
#include "app/gui/command_button.h"
#include "app/gui/panels.h"
#include "app/gui/short_text.h"
#include "app/gui/time_line.h"
#include "app/gui/widgets.h"
#include "render/theme.h"

namespace foldless {
namespace {

/// One of a row.
void command_icon(const char* name, Icon icon, Editor& editor, const Look& look) {
  command_button(name, icon, editor, look);
  ImGui::SameLine();
}

/// The time line is what is moved through.
bool is_in_motion(const Editor& editor) {
  return editor.motion().is_open() && !editor.race().is_open() && !editor.document().is_empty();
}

/// What the button in the middle would stop.
bool is_going(const Editor& editor) {
  if (editor.race().is_open()) return editor.race().is_playing();
  return is_in_motion(editor) ? editor.motion().play_head().is_playing()
                              : editor.playback().is_solving();
}

void draw_transport(Editor& editor, const Look& look) {
  if (!editor.race().is_open()) command_icon("motion.toggle", Icon::time_line, editor, look);
  command_icon("solve.first", Icon::first, editor, look);
  command_icon("solve.back", Icon::back, editor, look);
  ImGui::BeginDisabled(editor.document().is_empty());
  if (icon_button({.id = "toggle",
                   .icon = is_going(editor) ? Icon::pause : Icon::play,
                   .tip = is_going(editor)       ? "Pause (Space)"
                          : is_in_motion(editor) ? "Play (Space)"
                                                 : "Solve (Space)",
                   .is_main = true},
                  look))
    editor.run_command("solve.toggle");
  ImGui::EndDisabled();
  ImGui::SameLine();
  command_icon("solve.step", Icon::step, editor, look);
  command_icon("solve.last", Icon::last, editor, look);
  if (is_in_motion(editor)) return;
  command_icon("solve.stop", Icon::stop, editor, look);
  if (editor.race().is_open()) return;
  command_icon("solve.play", editor.playback().is_playing() ? Icon::pause : Icon::film, editor,
               look);
}

/// Ticks on the scrubber, the last item, where edges were flipped or split.
void draw_marks(const Editor& editor, const PanelContext& context) {
  const auto& iterations = editor.playback().iterations();
  if (iterations.size() < 2) return;
  const Look& look = context.look;
  const CanvasColours& colours = canvas_colours(context.state.settings.theme);
  const auto colour_of = [](const glm::vec4& c) { return packed({c.r, c.g, c.b, c.a}); };
  const ImU32 flipped = colour_of(colours.flipped), split = colour_of(colours.split);
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  // Where the middle of the knob stands, which is as wide as a step where there are few.
  const auto count = static_cast<float>(iterations.size());
  const float width = high.x - low.x - 4;
  const float knob = std::max(width / count, ImGui::GetStyle().GrabMinSize);
  const float margin = 2 + knob / 2, step = (width - knob) / (count - 1);
  // The colour of every column as wide as a mark, that runs of one colour are drawn at once.
  const float mark = std::max(1.0F, std::round(look.px(1)));
  std::vector<ImU32> columns(static_cast<std::size_t>(std::max(width + 4, 0.0F) / mark) + 1);
  for (std::size_t i = 0; i < iterations.size(); ++i) {
    const Iteration before = i > 0 ? iterations[i - 1] : Iteration{};
    const bool has_split = iterations[i].splits > before.splits;
    if (!has_split && iterations[i].flips <= before.flips) continue;
    const auto column = static_cast<std::size_t>((margin + step * static_cast<float>(i)) / mark);
    if (column >= columns.size() || columns[column] == split) continue;
    columns[column] = has_split ? split : flipped;
  }
  for (std::size_t first = 0; first < columns.size();) {
    std::size_t last = first + 1;
    while (last < columns.size() && columns[last] == columns[first]) ++last;
    if (columns[first] != 0)
      ImGui::GetWindowDrawList()->AddRectFilled(
          {low.x + mark * static_cast<float>(first), high.y - look.px(4)},
          {low.x + mark * static_cast<float>(last), high.y}, columns[first]);
    first = last;
  }
}

void draw_pace(Editor& editor, const Look& look) {
  static constexpr std::array kPaces{60, 30, 10, 5, 2, 1};
  const auto words = [](std::optional<double> pace) {
    return pace ? std::to_string(static_cast<int>(*pace)) + " a second" : std::string("Full speed");
  };
  ImGui::SetNextItemWidth(look.px(108));
  if (begin_combo("##pace", words(editor.playback().pace()))) {
    if (choice_entry("Full speed", !editor.playback().pace()))
      editor.playback().set_pace(std::nullopt);
    for (const int pace : kPaces)
      if (choice_entry(words(pace).c_str(), editor.playback().pace() == pace))
        editor.playback().set_pace(pace);
    ImGui::EndCombo();
  }
  tooltip("Pace: iterations a second, so that a solve that takes 5 ms can be watched.", look);
}

void draw_scrubber(Editor& editor, const PanelContext& context, float width) {
  const Look& look = context.look;
  const int count = static_cast<int>(editor.playback().iterations().size());
  ImGui::SetNextItemWidth(width);
  ImGui::BeginDisabled(!editor.playback().can_scrub());
  int shown =
      editor.playback().scrubbed() ? static_cast<int>(*editor.playback().scrubbed()) + 1 : count;
  const std::string words =
      count == 0 ? "No iterations yet"
                 : "Iteration " + std::to_string(shown) + " of " + std::to_string(count);
  const std::string fitting = elided(words, width - 2 * ImGui::GetStyle().FramePadding.x);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab,
                        count > 1 ? ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab) : ImVec4{});
  if (ImGui::SliderInt("##iteration", &shown, std::min(1, count), std::max(count, 1),
                       fitting.c_str(), ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
    editor.playback().scrub(static_cast<std::size_t>(std::max(shown, 1) - 1));
  ImGui::PopStyleColor();
  ImGui::EndDisabled();
  draw_marks(editor, context);
  tooltip(editor.playback().can_scrub()
              ? "Drag through the iterations since the last edit ( , and . step, P plays). Ticks "
                "mark flips of edges, orange ones splits."
              : "Pause or finish solving to go through its iterations.",
          look);
}

void draw_race_scrubber(Editor& editor, const Look& look, float width) {
  Race& race = editor.race();
  const int furthest = static_cast<int>(race.furthest());
  int tick = static_cast<int>(race.tick());
  const std::string words =
      "Iteration " + std::to_string(tick) + " of " + std::to_string(furthest) + " in every lane";
  const std::string fitting = elided(words, width - 2 * ImGui::GetStyle().FramePadding.x);
  ImGui::SetNextItemWidth(width);
  ImGui::BeginDisabled(furthest == 0);
  if (ImGui::SliderInt("##tick", &tick, 0, std::max(furthest, 1), fitting.c_str(),
                       ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput))
    race.scrub(static_cast<std::size_t>(std::max(tick, 0)));
  ImGui::EndDisabled();
  tooltip("Drag through the iterations of all lanes ( , and . step). Pauses the race.", look);
}

constexpr ImGuiWindowFlags kTimelineFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Beside the transport: the scrubber, and what goes with it.
void draw_iterations(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const bool has_use = editor.playback().scrubbed().has_value();
  const bool has_pace = ImGui::GetContentRegionAvail().x > look.px(has_use ? 320 : 230);
  const float right = (has_pace ? look.px(114) : 0) + (has_use ? look.px(82) : 0);
  const float width = std::max(look.px(40), ImGui::GetContentRegionAvail().x - right);
  if (editor.race().is_open())
    draw_race_scrubber(editor, look, width);
  else
    draw_scrubber(editor, context, width);
  if (has_use) {
    ImGui::SameLine();
    if (main_button("Use this", look)) editor.run_command("solve.use");
    tooltip("Go on from this iteration (Enter). One undo step.", look);
  }
  if (has_pace) {
    ImGui::SameLine();
    draw_pace(editor, look);
  }
}

}  // namespace

void draw_timeline_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& place = context.layout.timeline;
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, std::min(place.height, look.px(40))});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{look.px(7), look.px(4)});
  if (ImGui::Begin("##timeline", nullptr, kTimelineFlags)) {
    draw_transport(editor, look);
    if (is_in_motion(editor))
      draw_motion_controls(editor, context);
    else
      draw_iterations(editor, context);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  if (is_in_motion(editor)) draw_time_line(editor, context);
}

}  // namespace foldless
