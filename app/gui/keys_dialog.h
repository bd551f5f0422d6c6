// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/keymap.h"
#include "app/gui/look.h"

namespace foldless {

class Editor;

/// All commands with their keys, which are changed here.
class KeysDialog {
 public:
  void open();
  /// The next key press is a command's new key, whatever it is.
  bool is_capturing() const { return !captures_for_.empty(); }
  void draw(Editor& editor, const Look& look);

 private:
  /// Keys that a command is to get though another has one of them.
  struct Conflict {
    std::string command;
    std::vector<Shortcut> keys;
    std::string words;  ///< what is asked
  };

  void draw_head(Keymap& keymap, const Look& look);
  void draw_rows(Keymap& keymap, const Look& look);
  void draw_row(const KeyRow& row, Keymap& keymap, const Look& look);
  void draw_foot(Keymap& keymap, const Look& look);
  void capture(Keymap& keymap);
  void give(const std::string& command, std::vector<Shortcut> keys, Keymap& keymap);

  bool opens_now_ = false;
  std::string search_;
  std::string captures_for_;  ///< a command; empty: nothing is captured
  std::optional<Conflict> conflict_;
  std::string refusal_;  ///< why the last key press was not taken
};

}  // namespace foldless
