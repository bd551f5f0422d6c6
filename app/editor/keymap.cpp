// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/keymap.h"

#include <algorithm>
#include <array>
#include <utility>

namespace foldless {
namespace {

constexpr std::array kKeysOfDialogs{Key::escape, Key::enter, Key::tab, Key::space,
                                    Key::left,   Key::right, Key::up,  Key::down};
constexpr Shortcut kLassoKey{Key::l, {}};

bool has(std::span<const Shortcut> keys, const Shortcut& key) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Dialogs, lists and gestures need it.
bool is_reserved(const Shortcut& key) {
  return std::ranges::find(kKeysOfDialogs, key.key) != kKeysOfDialogs.end() || key == kLassoKey;
}

}  // namespace

Keymap::Keymap() {
  for (const Command& command : commands())
    rows_.push_back({.name = std::string(command.name),
                     .menu = std::string(command.menu),
                     .title = std::string(command.title),
                     .shortcuts = command.shortcuts,
                     .is_fixed = command.release != nullptr ||
                                 std::ranges::any_of(command.shortcuts, is_reserved)});
  refresh();
}

void Keymap::add(KeyRow row) {
  rows_.push_back(std::move(row));
  refresh();
}

const KeyRow* Keymap::find(std::string_view command) const {
  const auto it = std::ranges::find(rows_, command, &KeyRow::name);
  return it == rows_.end() ? nullptr : &*it;
}

void Keymap::choose(KeyChoice choice) {
  choice_ = std::move(choice);
  drop_what_is_no_change();
  refresh();
}

std::vector<Shortcut> Keymap::keys(std::string_view command) const {
  const auto it = in_force_.find(command);
  return it == in_force_.end() ? std::vector<Shortcut>() : it->second;
}

std::string Keymap::words(std::string_view command) const {
  const std::vector<Shortcut> shortcuts = keys(command);
  return shortcuts.empty() ? std::string() : words_of(shortcuts.front());
}

std::string_view Keymap::command_of(const Shortcut& key) const {
  for (const auto& [command, keys] : in_force_)
    if (has(keys, key)) return command;
  return {};
}

bool Keymap::is_changed(std::string_view command) const {
  return keys(command) != preset_keys(command);
}

std::string Keymap::refusal_of(const Shortcut& key) const {
  std::string words = words_of(key);
  if (key == kLassoKey) return words += " is held for the lasso; choose another key.";
  if (is_reserved(key)) return words += " is for dialogs and gestures; choose another key.";
  const KeyRow* owner = find(command_of(key));
  if (!owner || !owner->is_fixed) return {};
  return words.append(" is fixed to “").append(owner->title).append("”; choose another key.");
}

std::string Keymap::problem_of(std::string_view command, std::span<const Shortcut> keys) const {
  const KeyRow* row = find(command);
  if (!row) return "There is no such command.";
  if (row->is_fixed) return "Its keys are fixed.";
  for (const Shortcut& key : keys)
    if (std::string refusal = refusal_of(key); !refusal.empty()) return refusal;
  return {};
}

void Keymap::set(const std::string& command, std::vector<Shortcut> keys) {
  for (auto& change : choice_.changes)
    std::erase_if(change.second, [&keys](const Shortcut& key) { return has(keys, key); });
  choice_.changes[command] = std::move(keys);
  drop_what_is_no_change();
  refresh();
}

std::vector<Shortcut> Keymap::preset_keys(std::string_view command) const {
  if (const KeyPreset* preset = find_key_preset(choice_.preset))
    for (const KeyDifference& difference : preset->differences)
      if (difference.command == command) return difference.keys;
  const KeyRow* row = find(command);
  return row ? row->shortcuts : std::vector<Shortcut>();
}

void Keymap::reset() {
  choice_.changes.clear();
  refresh();
}

bool Keymap::is_given_elsewhere(const Shortcut& key) const {
  return std::ranges::any_of(choice_.changes,
                             [&key](const auto& change) { return has(change.second, key); });
}

void Keymap::drop_what_is_no_change() {
  std::erase_if(choice_.changes,
                [this](const auto& change) { return change.second == preset_keys(change.first); });
}

void Keymap::refresh() {
  in_force_.clear();
  for (const KeyRow& row : rows_) {
    const auto change = choice_.changes.find(row.name);
    std::vector<Shortcut>& keys = in_force_[row.name];
    if (change != choice_.changes.end()) {
      keys = change->second;
      continue;
    }
    keys = preset_keys(row.name);
    std::erase_if(keys, [this](const Shortcut& key) { return is_given_elsewhere(key); });
  }
}

}  // namespace foldless
