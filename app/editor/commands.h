// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/input.h"

namespace foldless {

class Editor;

/// A key with its modifiers.
struct Shortcut {
  Key key = Key::none;
  Modifiers modifiers;

  bool operator==(const Shortcut&) const = default;
};

/// One thing a user can ask for: feeds menus, keys, search and cheat sheet.
struct Command {
  std::string_view name;            ///< stable, `edit.undo`
  std::string_view menu;            ///< `File`, `Edit`, `Select`, `Solve`, `View`, `Help`
  std::string_view title;           ///< words in menus and search
  std::vector<Shortcut> shortcuts;  ///< the program's own, see Keymap; menus show the first one
  bool (*is_enabled)(const Editor&);
  void (*run)(Editor&);
  /// State of a switch, or null for commands that are none.
  bool (*is_checked)(const Editor&) = nullptr;
  /// Called when the key is let go, for commands that last as long as it is held; else null.
  void (*release)(Editor&) = nullptr;
  bool repeats = false;  ///< runs again while its key is held down
  bool in_race = false;  ///< makes sense while a race covers the document
};

/// Every command in menu order.
std::span<const Command> commands();

/// The command of that name, or null.
const Command* find_command(std::string_view name);

/// True when the command can be run now.
bool is_available(const Command& command, const Editor& editor);

/// `Ctrl+Shift+S`.
std::string words_of(const Shortcut& shortcut);
/// The shortcut that has these words; nothing where none has.
std::optional<Shortcut> shortcut_of(std::string_view words);

}  // namespace foldless
