// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/command_button.h"

#include <string>

#include "app/editor/commands.h"
#include "app/gui/widgets.h"

namespace foldless {

void command_button(std::string_view name, Icon icon, Editor& editor, const Look& look) {
  const Command* command = find_command(name);
  if (!command) return;
  const std::string key = editor.keys().words(name);
  std::string tip(command->title);
  if (!key.empty()) tip.append(" (").append(key).append(")");
  const bool is_on = command->is_checked && command->is_checked(editor);
  ImGui::BeginDisabled(!is_available(*command, editor));
  if (icon_button({.id = name.data(), .icon = icon, .tip = tip, .is_chosen = is_on}, look))
    editor.run_command(name);
  ImGui::EndDisabled();
}

}  // namespace foldless
