// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <optional>
#include <string>

#include "app/editor/handle_edits.h"
#include "app/editor/turning.h"
#include "app/gui/choice_list.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// A row of what the selected handles have: its name, and the next item fills the rest.
void begin_field(const char* name, const Look& look) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  ImGui::SameLine(look.px(64));
  ImGui::SetNextItemWidth(-1);
}

/// A typed number counts with Enter: a click elsewhere may select other handles at once.
std::optional<double> draw_number(const char* id, std::optional<double> common, double step) {
  double value = common.value_or(0);
  constexpr ImGuiInputTextFlags kValueFlags =
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  const char* format = common ? "%.6g" : "several";
  if (!ImGui::InputDouble(id, &value, step, 10 * step, format, kValueFlags)) return std::nullopt;
  return value;
}

void draw_kind_choice(const SelectedHandles& selected, Editor& editor, const Look& look) {
  static constexpr std::array kTitles{"Drag", "Pin", "Soft"};  // in the order of HandleKind
  begin_field("Kind", look);
  const char* title = selected.kind ? kTitles[static_cast<std::size_t>(*selected.kind)] : "several";
  if (begin_combo("##kind", title)) {
    for (std::size_t i = 0; i < kTitles.size(); ++i)
      if (choice_entry(kTitles[i], selected.kind == static_cast<HandleKind>(i)))
        set_kind(editor, static_cast<HandleKind>(i));
    ImGui::EndCombo();
  }
  tooltip(
      "Drag and pin handles are met exactly and told apart by shape; K toggles. A soft one "
      "gives way: its weight says how hard it pulls.",
      look);
}

/// Typed, it counts with Enter and with a click elsewhere, for the handles that it was typed for.
void draw_name(const SelectedHandles& selected, Editor& editor, const PanelContext& context) {
  begin_field("Name", context.look);
  std::string name = selected.name.value_or("");
  const bool is_taken = ImGui::InputTextWithHint(
      "##handle name", selected.name ? "none" : "several", &name,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (is_taken) set_name(editor, name);
  tooltip("What the list calls it; Enter takes it.", context.look);
}

void draw_position(const SelectedHandles& selected, Editor& editor, const Look& look) {
  const std::array<std::optional<double>, 2> common{selected.x, selected.y};
  constexpr std::array kAxisNames{"X", "Y"};
  constexpr std::array kAxisIds{"##x", "##y"};
  for (int axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    begin_field(kAxisNames[i], look);
    if (const auto value = draw_number(kAxisIds[i], common[i], 0))
      set_coordinate(editor, axis, *value);
    tooltip("Where it should be, in the units of the mesh.", look);
  }
}

/// Whether the mesh turns with them, how far, and how much of it.
void draw_turn(const SelectedHandles& selected, Editor& editor, const Look& look) {
  begin_field("Turns", look);
  bool turns = selected.turns.value_or(false);
  if (ImGui::Checkbox("##turns", &turns)) set_turning(editor, turns);
  tooltip(
      "The mesh round it turns with it, rigidly. Drag the ring round the selected handle, or press "
      "R; without, the mesh is free to turn.",
      look);
  if (selected.turns == false) return;
  begin_field("Angle", look);
  if (const auto angle = draw_number("##angle", selected.angle, 15)) set_angle(editor, *angle);
  tooltip("In degrees from the undeformed shape, counter-clockwise.", look);
  begin_field("Radius", look);
  if (const auto radius = draw_number("##radius", selected.radius, 0)) set_radius(editor, *radius);
  tooltip("How far the mesh follows, measured on the undeformed shape.", look);
}

/// How stiff the mesh round them is, and how far.
void draw_stiffness(const SelectedHandles& selected, Editor& editor, const Look& look) {
  begin_field("Stiff", look);
  if (const auto factor = draw_number("##stiffness", selected.stiffness, 0))
    set_stiffness(editor, *factor);
  tooltip(
      "So many times as stiff round it, 0.1 to 1000; 1 is as stiff as ever. What the brush has "
      "painted there is multiplied.",
      look);
  if (selected.stiffness == 1) return;
  begin_field("within", look);
  if (const auto radius = draw_number("##stiff radius", selected.stiff_radius, 0))
    set_stiff_radius(editor, *radius);
  tooltip("How far the stiffness reaches, measured on the undeformed shape.", look);
}

}  // namespace

void draw_handle_inspector(Editor& editor, const PanelContext& context) {
  const SelectedHandles selected = selected_handles(editor);
  if (!selected.are_there) return;
  const Look& look = context.look;
  draw_name(selected, editor, context);
  draw_kind_choice(selected, editor, look);
  if (selected.kind == HandleKind::soft) {
    begin_field("Weight", look);
    if (const auto weight = draw_number("##weight", selected.weight, 0.1))
      set_weight(editor, *weight);
    tooltip("How hard it pulls against the energy, 0.001 to 1000.", look);
  }
  draw_position(selected, editor, look);
  draw_turn(selected, editor, look);
  draw_stiffness(selected, editor, look);
  begin_field("Depth", look);
  if (const auto depth = draw_number("##depth", selected.depth, 1)) set_depth(editor, *depth);
  tooltip(
      "The larger is in front where the mesh lies over itself; between handles it changes "
      "evenly. [ sends back, ] brings forward.",
      look);
}

}  // namespace foldless
