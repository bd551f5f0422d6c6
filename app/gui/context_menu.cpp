// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/context_menu.h"

#include <imgui.h>

#include <array>
#include <span>
#include <string_view>
#include <utility>

#include "app/gui/command_item.h"

namespace foldless {
namespace {

constexpr const char* kPopup = "##context";

/// Names of commands; an empty one is a line between groups.
constexpr std::array<std::string_view, 13> kOfHandle{"handle.pin",
                                                     "handle.turn",
                                                     "",
                                                     "handle.forward",
                                                     "handle.back",
                                                     "",
                                                     "bones.make",
                                                     "bones.remove",
                                                     "mirror.pose",
                                                     "",
                                                     "view.fit_selection",
                                                     "",
                                                     "edit.delete"};
constexpr std::array<std::string_view, 14> kOfCanvas{"edit.undo",
                                                     "edit.redo",
                                                     "edit.reset_pose",
                                                     "",
                                                     "select.all",
                                                     "select.none",
                                                     "",
                                                     "view.fit",
                                                     "view.actual_size",
                                                     "view.mesh",
                                                     "view.remesh_diff",
                                                     "",
                                                     "file.snapshot",
                                                     "file.export"};

void draw_rows(std::span<const std::string_view> names, Editor& editor) {
  for (const std::string_view name : names) {
    const Command* command = find_command(name);
    if (command)
      draw_command_item(*command, editor);
    else
      ImGui::Separator();
  }
}

}  // namespace

void ContextMenu::open(Editor& editor) {
  Selection& selection = editor.selection();
  const auto hovered = selection.hovered();
  is_of_handle_ = hovered.has_value();
  if (hovered && !selection.ids().contains(*hovered)) selection.select({*hovered});
  is_asked_for_ = true;
}

void ContextMenu::draw(Editor& editor, const Look& look) {
  if (std::exchange(is_asked_for_, false)) ImGui::OpenPopup(kPopup);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{look.px(10), look.px(7)});
  if (ImGui::BeginPopup(kPopup)) {
    if (is_of_handle_)
      draw_rows(kOfHandle, editor);
    else
      draw_rows(kOfCanvas, editor);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

}  // namespace foldless
