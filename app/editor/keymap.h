// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands.h"
#include "app/editor/key_presets.h"

namespace foldless {

/// A command as far as its keys go.
struct KeyRow {
  std::string name;                 ///< stable, `edit.undo`
  std::string menu;                 ///< that it is in
  std::string title;                ///< words on screen
  std::vector<Shortcut> shortcuts;  ///< the program's own
  bool is_fixed = false;            ///< its keys cannot be changed
};

/// What the user chose, a preset and what differs from it.
struct KeyChoice {
  std::string preset{kOwnKeys};
  std::map<std::string, std::vector<Shortcut>> changes;  ///< by command, all its keys

  bool operator==(const KeyChoice&) const = default;
};

/// Which key asks for which command: the program's own keys, changed by a preset, changed by the
/// user. A key belongs to one command: one that the user gave away is missing where it was.
class Keymap {
 public:
  /// The keys of commands().
  Keymap();
  /// One more command.
  void add(KeyRow row);
  std::span<const KeyRow> rows() const { return rows_; }
  /// The row of that command, or null.
  const KeyRow* find(std::string_view command) const;

  const KeyChoice& choice() const { return choice_; }
  /// Changes that problem_of() has nothing against.
  void choose(KeyChoice choice);

  /// The keys in force; none for an unknown command.
  std::vector<Shortcut> keys(std::string_view command) const;
  /// The first one in words, or empty.
  std::string words(std::string_view command) const;
  /// The command that a key asks for; empty where there is none.
  std::string_view command_of(const Shortcut& key) const;
  /// Its keys are not those of the preset.
  bool is_changed(std::string_view command) const;

  /// Why a key can be given to no command, one sentence; empty: it can.
  std::string refusal_of(const Shortcut& key) const;
  /// Why a command cannot have these keys, one sentence; empty: it can.
  std::string problem_of(std::string_view command, std::span<const Shortcut> keys) const;

  /// Gives a command these keys and takes them from those that have them.
  void set(const std::string& command, std::vector<Shortcut> keys);
  /// What the preset gives the command.
  std::vector<Shortcut> preset_keys(std::string_view command) const;
  /// All keys of the preset.
  void reset();

 private:
  bool is_given_elsewhere(const Shortcut& key) const;
  void drop_what_is_no_change();
  void refresh();

  std::vector<KeyRow> rows_;
  std::map<std::string, std::vector<Shortcut>, std::less<>> in_force_;  ///< by command
  KeyChoice choice_;
};

}  // namespace foldless
