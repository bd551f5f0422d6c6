// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>
#include <set>
#include <string>

#include "app/editor/handle_depth.h"
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

/// A typed number counts with Enter: a click elsewhere may select other handles at once.
void draw_depth(Editor& editor, const Look& look) {
  const SelectedDepth selected = selected_depth(editor);
  if (!selected.is_there) return;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Depth");
  ImGui::SameLine(look.px(64));
  ImGui::SetNextItemWidth(-1);
  double depth = selected.common.value_or(0);
  const char* format = selected.common ? "%.6g" : "several";
  constexpr ImGuiInputTextFlags kFlags =
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  if (ImGui::InputDouble("##depth", &depth, 1, 10, format, kFlags)) set_depth(editor, depth);
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
  draw_depth(editor, context.look);
}

}  // namespace foldless
