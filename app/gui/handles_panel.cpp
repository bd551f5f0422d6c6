// SPDX-License-Identifier: GPL-3.0-or-later
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/handle_edits.h"
#include "app/gui/directory.h"
#include "app/gui/panels.h"
#include "app/gui/short_text.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

constexpr std::size_t kManyHandles = 8;

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

/// A field to search the names with, where there are many.
void draw_search(std::string& text, std::size_t handles) {
  if (handles < kManyHandles) return text.clear();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##search", "Search", &text);
}

/// In place of a row: Enter takes the name, Esc and a click elsewhere leave it.
void draw_name_field(NameField& field, Editor& editor, UiState& state) {
  const bool is_new = std::exchange(field.is_new, false);
  if (is_new) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{ImGui::GetStyle().FramePadding.x, 0});
  const bool is_taken =
      ImGui::InputText("##name of row", &field.text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  if (is_taken) set_name(editor, field.text);
  if (is_taken || ImGui::IsItemDeactivated()) state.handle_name.reset();
}

/// By its command, where the one handle that is selected is in the list on screen.
void begin_name_field(const Editor& editor, UiState& state) {
  const auto& selected = editor.selection().ids();
  const bool is_asked = ImGui::GetFrameCount() - state.handle_name_frame <= 1;
  if (!is_asked || selected.size() != 1 || state.handle_name) return;
  state.handle_name_frame = kNoFrame;
  const Handle* handle = find_handle(editor.document(), *selected.begin());
  if (handle) state.handle_name = NameField{handle->id, handle->name};
}

void scroll_to_name_field(const std::vector<HandleView>& handles, const UiState& state) {
  if (!state.handle_name || !state.handle_name->is_new) return;
  const auto row = std::ranges::find(handles, state.handle_name->handle, &HandleView::id);
  if (row == handles.end()) return;
  const float top =
      static_cast<float>(row - handles.begin()) * ImGui::GetTextLineHeightWithSpacing();
  ImGui::SetScrollFromPosY(ImGui::GetCursorStartPos().y + top - ImGui::GetScrollY());
}

void draw_row(const HandleView& handle, Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  if (auto& field = context.state.handle_name; field && field->handle == handle.id)
    return draw_name_field(*field, editor, context.state);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::PushID(handle.id);
  const bool clicked =
      ImGui::Selectable("##handle", handle.is_selected, ImGuiSelectableFlags_AllowDoubleClick);
  if (ImGui::IsItemHovered()) editor.selection().hover(handle.id);
  ImGui::PopID();
  const float line = ImGui::GetTextLineHeight();
  draw_kind(handle.kind, {corner.x + look.px(8), corner.y + line / 2}, look, handle.is_at_target);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string name = handle_title(handle.name, handle.vertex);
  const std::string residual = residual_words(handle);
  const float width = ImGui::CalcTextSize(residual.c_str()).x;
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  list.AddText({right - width, corner.y},
               packed(handle.is_at_target ? look.palette->dim : look.palette->warning),
               residual.c_str());
  const float left = corner.x + look.px(20);
  list.AddText({left, corner.y}, packed(look.palette->text),
               elided(name, right - width - look.px(8) - left).c_str());
  if (!clicked) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    editor.selection().select({handle.id});
    context.state.handle_name = NameField{handle.id, handle.name};
    return;
  }
  std::set<int> selection =
      context.state.modifiers.shift ? editor.selection().ids() : std::set<int>{};
  if (!selection.erase(handle.id)) selection.insert(handle.id);
  editor.selection().select(std::move(selection));
}

}  // namespace

void draw_handles_panel(Editor& editor, const PanelContext& context) {
  auto handles = handle_views(editor.draft());
  if (handles.empty()) {
    ImGui::PushTextWrapPos(0);
    dim_text("Click on the mesh to place one, drag to bend.", context.look);
    ImGui::PopTextWrapPos();
    return;
  }
  begin_name_field(editor, context.state);
  std::string& search = context.state.handle_search;
  draw_search(search, handles.size());
  std::erase_if(handles, [&](const HandleView& handle) {
    return !search.empty() && !matches_filter(handle_title(handle.name, handle.vertex), search);
  });
  const float most = context.look.px(220);
  begin_rows({0, std::min(rows_height(handles.size(), context.look), most)}, context.look);
  scroll_to_name_field(handles, context.state);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(handles.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(handles[static_cast<std::size_t>(i)], editor, context);
  ImGui::EndChild();
  draw_handle_inspector(editor, context);
}

}  // namespace foldless
