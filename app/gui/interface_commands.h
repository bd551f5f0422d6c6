// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/keymap.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// What a user can ask of the interface rather than of the editor: its look, its panels. Feeds
/// menus, keys and search, as the editor's commands do.
struct InterfaceCommand {
  std::string name;          ///< stable, `view.panels`
  std::string_view menu;     ///< that it is in
  std::string_view submenu;  ///< of that; empty: in the menu itself
  std::string title;
  std::vector<Shortcut> shortcuts;  ///< the program's own, see Keymap
  std::function<void(UiState&)> run;
  /// State of a switch; empty for commands that are none.
  std::function<bool(const UiState&)> is_checked;
};

/// Every command in menu order; those of a submenu follow each other.
const std::vector<InterfaceCommand>& interface_commands();

/// Runs the command of that name, if there is one; returns whether there was.
bool run_interface_command(std::string_view name, UiState& state);

/// The words of a command without its menu: `Theme: Dark`.
std::string words_in_menu(const InterfaceCommand& command);

/// The keys of all commands, the editor's and the interface's.
Keymap all_keys();

/// One line of the search: a command, a sample, a recent file.
struct Action {
  std::string words;     ///< `View: Theme: Dark`
  std::string shortcut;  ///< in words, may be empty
  bool is_available = true;
  std::function<void()> run;
};

/// Everything that can be asked for. They keep the references.
std::vector<Action> all_actions(Editor& editor, UiState& state);

}  // namespace foldless
