// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <optional>
#include <set>
#include <string>

#include "app/editor/handle_edits.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

std::string residual_words(const HandleView& handle) {
  if (handle.is_at_target) return "at target";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g away", handle.residual);
  return text.data();
}

/// A handle's picture, as on the canvas: circles are dragged, squares are pinned.
void draw_kind(HandleKind kind, const ImVec2& centre, const Look& look, bool is_at_target) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = look.px(4);
  const ImU32 colour = packed(is_at_target ? look.palette->good : look.palette->warning);
  switch (kind) {
    case HandleKind::drag: list.AddCircleFilled(centre, r, colour); break;
    case HandleKind::pin:
      list.AddRectFilled({centre.x - r, centre.y - r}, {centre.x + r, centre.y + r}, colour);
      break;
    case HandleKind::soft: list.AddCircle(centre, r, colour, 0, look.px(1.6F)); break;
  }
}

void draw_row(const HandleView& handle, Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(handle.id);
  const bool clicked = ImGui::Selectable("##handle", handle.is_selected);
  if (ImGui::IsItemHovered()) editor.selection().hover(handle.id);
  ImGui::PopID();
  const float line = ImGui::GetTextLineHeight();
  draw_kind(handle.kind, {corner.x + look.px(8), corner.y + line / 2}, look, handle.is_at_target);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string name = "Vertex " + std::to_string(handle.vertex);
  list.AddText({corner.x + look.px(20), corner.y}, packed(look.palette->text), name.c_str());
  const std::string residual = residual_words(handle);
  const float width = ImGui::CalcTextSize(residual.c_str()).x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  list.AddText({right - width, corner.y},
               packed(handle.is_at_target ? look.palette->dim : look.palette->warning),
               residual.c_str());
  if (!clicked) return;
  std::set<int> selection =
      context.state.modifiers.shift ? editor.selection().ids() : std::set<int>{};
  if (!selection.erase(handle.id)) selection.insert(handle.id);
  editor.selection().select(std::move(selection));
}

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
  constexpr ImGuiInputTextFlags kFlags =
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  const char* format = common ? "%.6g" : "several";
  if (!ImGui::InputDouble(id, &value, step, 10 * step, format, kFlags)) return std::nullopt;
  return value;
}

void draw_kind_choice(const SelectedHandles& selected, Editor& editor, const Look& look) {
  static constexpr std::array kTitles{"Drag", "Pin", "Soft"};  // in the order of HandleKind
  begin_field("Kind", look);
  const char* title = selected.kind ? kTitles[static_cast<std::size_t>(*selected.kind)] : "several";
  if (ImGui::BeginCombo("##kind", title)) {
    for (std::size_t i = 0; i < kTitles.size(); ++i)
      if (ImGui::Selectable(kTitles[i])) set_kind(editor, static_cast<HandleKind>(i));
    ImGui::EndCombo();
  }
  tooltip(
      "Drag and pin handles are met exactly and told apart by shape; K toggles. A soft one "
      "gives way: its weight says how hard it pulls.",
      look);
}

void draw_inspector(Editor& editor, const Look& look) {
  const SelectedHandles selected = selected_handles(editor);
  if (!selected.are_there) return;
  draw_kind_choice(selected, editor, look);
  if (selected.kind == HandleKind::soft) {
    begin_field("Weight", look);
    if (const auto weight = draw_number("##weight", selected.weight, 0.1))
      set_weight(editor, *weight);
    tooltip("How hard it pulls against the energy, 0.001 to 1000.", look);
  }
  begin_field("Depth", look);
  if (const auto depth = draw_number("##depth", selected.depth, 1)) set_depth(editor, *depth);
  tooltip(
      "The larger is in front where the mesh lies over itself; between handles it changes "
      "evenly. [ sends back, ] brings forward.",
      look);
}

}  // namespace

void draw_handles_panel(Editor& editor, const PanelContext& context) {
  const auto handles = handle_views(editor.draft());
  if (handles.empty()) {
    ImGui::PushTextWrapPos(0);
    dim_text("Click on the mesh to place one, drag to bend.", context.look);
    ImGui::PopTextWrapPos();
    return;
  }
  const float row = ImGui::GetTextLineHeightWithSpacing();
  const float most = context.look.px(220);
  const float height =
      std::min(row * static_cast<float>(handles.size()) + context.look.px(4), most);
  ImGui::BeginChild("rows", {0, height});
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(handles.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(handles[static_cast<std::size_t>(i)], editor, context);
  ImGui::EndChild();
  draw_inspector(editor, context.look);
}

}  // namespace foldless
