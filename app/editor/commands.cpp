// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/commands.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/editor/command_table.h"
#include "app/editor/editor.h"

namespace foldless {
namespace {

std::string words_of(Key key) {
  if (key >= Key::a && key <= Key::z)
    return {static_cast<char>('A' + static_cast<int>(key) - static_cast<int>(Key::a))};
  if (key >= Key::digit_0 && key <= Key::digit_9)
    return {static_cast<char>('0' + static_cast<int>(key) - static_cast<int>(Key::digit_0))};
  if (key >= Key::f1 && key <= Key::f12)
    return std::string("F").append(
        std::to_string(1 + static_cast<int>(key) - static_cast<int>(Key::f1)));
  static constexpr std::array kWords = std::to_array<std::pair<Key, std::string_view>>(
      {{Key::space, "Space"},    {Key::escape, "Esc"},
       {Key::enter, "Enter"},    {Key::tab, "Tab"},
       {Key::del, "Delete"},     {Key::backspace, "Backspace"},
       {Key::home, "Home"},      {Key::end, "End"},
       {Key::left, "Left"},      {Key::right, "Right"},
       {Key::up, "Up"},          {Key::down, "Down"},
       {Key::plus, "+"},         {Key::minus, "-"},
       {Key::comma, ","},        {Key::period, "."},
       {Key::slash, "/"},        {Key::backslash, "\\"},
       {Key::left_bracket, "["}, {Key::right_bracket, "]"},
       {Key::page_up, "PageUp"}, {Key::page_down, "PageDown"}});
  const auto* it = std::find_if(kWords.begin(), kWords.end(),
                                [key](const auto& entry) { return entry.first == key; });
  return it == kWords.end() ? std::string() : std::string(it->second);
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> table = command_table();
  return table;
}

const Command* find_command(std::string_view name) {
  const auto table = commands();
  const auto it =
      std::find_if(table.begin(), table.end(), [name](const Command& c) { return c.name == name; });
  return it == table.end() ? nullptr : &*it;
}

bool is_available(const Command& command, const Editor& editor) {
  return (command.in_race || !editor.race().is_open()) && command.is_enabled(editor);
}

std::string words_of(const Shortcut& shortcut) {
  std::string words;
  if (shortcut.modifiers.control) words += "Ctrl+";
  if (shortcut.modifiers.alt) words += "Alt+";
  if (shortcut.modifiers.shift) words += "Shift+";
  return words + words_of(shortcut.key);
}

std::optional<Shortcut> shortcut_of(std::string_view words) {
  Shortcut shortcut;
  const auto takes = [&words](std::string_view prefix) {
    const bool has_it = words.starts_with(prefix);
    if (has_it) words.remove_prefix(prefix.size());
    return has_it;
  };
  shortcut.modifiers.control = takes("Ctrl+");
  shortcut.modifiers.alt = takes("Alt+");
  shortcut.modifiers.shift = takes("Shift+");
  for (int key = 1; key <= static_cast<int>(kLastKey); ++key) {
    shortcut.key = static_cast<Key>(key);
    if (words_of(shortcut.key) == words) return shortcut;
  }
  return std::nullopt;
}

}  // namespace foldless
