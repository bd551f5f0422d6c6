// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/command_item.h"

#include <imgui.h>

#include <string>

namespace foldless {

void draw_command_item(const Command& command, Editor& editor) {
  const bool is_checked = command.is_checked && command.is_checked(editor);
  if (ImGui::MenuItem(std::string(command.title).c_str(), editor.keys().words(command.name).c_str(),
                      is_checked, is_available(command, editor)))
    editor.run_command(command.name);
}

}  // namespace foldless
