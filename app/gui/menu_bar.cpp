// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include "app/editor/commands.h"
#include "app/gui/command_item.h"
#include "app/gui/interface_commands.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

void draw_samples(Editor& editor, const PanelContext& context) {
  if (!ImGui::BeginMenu("Samples", !context.state.samples.empty())) return;
  for (const Sample& sample : context.state.samples) {
    if (ImGui::MenuItem(sample.title.c_str())) editor.files().open_sample(sample.path);
    tooltip(sample.description, context.look);
  }
  ImGui::EndMenu();
}

void draw_recent(Editor& editor) {
  if (!ImGui::BeginMenu("Open recent", !editor.files().recent().empty())) return;
  const auto recent = editor.files().recent();
  for (const auto& path : recent)
    if (ImGui::MenuItem(path.c_str())) editor.files().open(path);
  ImGui::EndMenu();
}

void draw_command(const InterfaceCommand& command, const Keymap& keys, UiState& state) {
  const bool is_checked = command.is_checked && command.is_checked(state);
  if (ImGui::MenuItem(command.title.c_str(), keys.words(command.name).c_str(), is_checked))
    command.run(state);
}

/// What a menu has of the interface, its submenus where their first command stands.
void draw_interface_commands(std::string_view menu, const Keymap& keys, UiState& state) {
  std::string_view done;
  for (const InterfaceCommand& command : interface_commands()) {
    if (command.menu != menu || (!done.empty() && command.submenu == done)) continue;
    if (command.submenu.empty()) {
      draw_command(command, keys, state);
      continue;
    }
    done = command.submenu;
    if (!ImGui::BeginMenu(std::string(done).c_str())) continue;
    for (const InterfaceCommand& inner : interface_commands())
      if (inner.menu == menu && inner.submenu == done) draw_command(inner, keys, state);
    ImGui::EndMenu();
  }
}

void draw_extras(std::string_view menu, Editor& editor, const PanelContext& context) {
  if (menu == "File" || menu == "Edit" || menu == "View") ImGui::Separator();
  if (menu == "File") {
    draw_recent(editor);
    draw_samples(editor, context);
  }
  draw_interface_commands(menu, editor.keys(), context.state);
}

/// The name of the document in the middle of what is left of the bar.
void draw_document_name(const Editor& editor, const PanelContext& context) {
  const std::string title = editor.files().title();
  const float width = ImGui::CalcTextSize(title.c_str()).x;
  const float middle = (context.layout.menu_bar.width - width) / 2;
  if (middle < ImGui::GetCursorPosX() + context.look.px(12)) return;
  ImGui::SameLine(middle);
  ImGui::TextColored(context.look.palette->dim, "%s", title.c_str());
}

}  // namespace

void draw_menu_bar(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const float padding =
      std::max(0.0F, (context.layout.menu_bar.height - look.fonts.text->FontSize) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{look.px(8), padding});
  const bool is_open = ImGui::BeginMainMenuBar();
  ImGui::PopStyleVar();
  if (!is_open) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2{look.px(10), look.px(7)});
  for (const char* menu : {"File", "Edit", "Handles", "Solve", "Motion", "View", "Help"}) {
    if (!ImGui::BeginMenu(menu)) continue;
    for (const Command& command : commands())
      if (command.menu == menu) draw_command_item(command, editor);
    draw_extras(menu, editor, context);
    ImGui::EndMenu();
  }
  draw_document_name(editor, context);
  ImGui::PopStyleVar();
  ImGui::EndMainMenuBar();
}

}  // namespace foldless
