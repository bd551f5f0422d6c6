// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/key_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/gui/interface_commands.h"
#include "core/error.h"

namespace foldless {
namespace {

/// Throws Error.
std::vector<Shortcut> read_shortcuts(const nlohmann::json& words) {
  if (!words.is_array()) throw Error("A list of keys is needed.");
  std::vector<Shortcut> shortcuts;
  for (const auto& entry : words) {
    const auto shortcut =
        entry.is_string() ? shortcut_of(entry.get<std::string>()) : std::optional<Shortcut>();
    if (!shortcut) throw Error(entry.dump() + " is no key.");
    shortcuts.push_back(*shortcut);
  }
  return shortcuts;
}

/// Throws Error where two commands would have the same key.
void refuse_doubles(const std::vector<Shortcut>& keys, const KeyChoice& choice) {
  for (const auto& change : choice.changes)
    for (const Shortcut& key : keys)
      if (std::ranges::find(change.second, key) != change.second.end())
        throw Error(words_of(key) + " is given to \"" + change.first + "\" already.");
}

void read_preset(const nlohmann::json& name, KeyChoice& choice) {
  if (!name.is_string() || !find_key_preset(name.get<std::string>()))
    throw Error("There is no preset of keys " + name.dump() + "; the program's own are in force.");
  choice.preset = name.get<std::string>();
}

void read_change(const std::string& command, const nlohmann::json& words, const Keymap& keymap,
                 KeyChoice& choice) {
  try {
    const std::vector<Shortcut> keys = read_shortcuts(words);
    if (const std::string problem = keymap.problem_of(command, keys); !problem.empty())
      throw Error(problem);
    refuse_doubles(keys, choice);
    choice.changes[command] = keys;
  } catch (const Error& error) {
    throw Error("The keys of \"" + command + "\" stay as they were. " + error.what());
  }
}

}  // namespace

nlohmann::json keys_json(const KeyChoice& choice) {
  nlohmann::json changes = nlohmann::json::object();
  for (const auto& change : choice.changes) {
    nlohmann::json& words = changes[change.first] = nlohmann::json::array();
    for (const Shortcut& key : change.second) words.push_back(words_of(key));
  }
  return {{"preset", choice.preset}, {"changes", std::move(changes)}};
}

std::pair<KeyChoice, std::string> read_keys(const nlohmann::json& json) {
  if (!json.is_object()) return {{}, "\"keys\" is no object; the program's own are in force."};
  std::pair<KeyChoice, std::string> read;
  auto& [choice, problem] = read;
  const Keymap keymap = all_keys();
  std::size_t others = 0;
  const auto attempt = [&read, &others](const auto& action) {
    try {
      action();
    } catch (const Error& error) {
      if (read.second.empty())
        read.second = error.what();
      else
        ++others;
    }
  };
  if (const auto preset = json.find("preset"); preset != json.end())
    attempt([&] { read_preset(*preset, read.first); });
  if (const auto changes = json.find("changes"); changes != json.end())
    for (const auto& entry : changes->items())
      attempt([&] { read_change(entry.key(), entry.value(), keymap, read.first); });
  if (others > 0) problem += " More that is of no use: " + std::to_string(others) + ".";
  return read;
}

}  // namespace foldless
