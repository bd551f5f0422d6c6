// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "app/editor/autosave.h"
#include "app/editor/scene_document.h"
#include "app/gui/key_settings.h"
#include "core/files/atomic_file.h"
#include "core/files/small_file.h"

namespace foldless {
namespace {

constexpr double kLeastWindow = 200, kLargestWindow = 16384;
constexpr std::array kThemeNames{"dark", "light", "contrast"};  // in the order of Theme

Theme theme_named(const std::string& name) {
  const auto found = std::ranges::find(kThemeNames, name);
  return found == kThemeNames.end() ? Theme::dark : static_cast<Theme>(found - kThemeNames.begin());
}

/// What an object has under a key; what makes no sense is passed over.
struct Reader {
  const nlohmann::json& json;

  const nlohmann::json* find(const char* key) const {
    const auto it = json.find(key);
    return it == json.end() ? nullptr : &*it;
  }
  template <class Number>
  void number(const char* key, Number& value, double least, double most) const {
    if (const auto* found = find(key); found && found->is_number())
      value = static_cast<Number>(std::clamp(found->get<double>(), least, most));
  }
  void boolean(const char* key, bool& value) const {
    if (const auto* found = find(key); found && found->is_boolean()) value = found->get<bool>();
  }
  std::vector<std::string> texts(const char* key) const {
    std::vector<std::string> texts;
    if (const auto* found = find(key); found && found->is_array())
      for (const auto& entry : *found)
        if (entry.is_string()) texts.push_back(entry.get<std::string>());
    return texts;
  }
};

}  // namespace

std::filesystem::path settings_file(const std::filesystem::path& state_folder) {
  return state_folder.empty() ? state_folder : state_folder / "settings.json";
}

Settings load_settings(const std::filesystem::path& file) {
  Settings settings;
  const auto json = nlohmann::json::parse(read_small_file(file), nullptr, false);
  if (!json.is_object()) return settings;
  const Reader read{json};
  read.number("scale", settings.scale, kSmallestScale, kLargestScale);
  read.boolean("panels", settings.shows_panels);
  read.boolean("artboard", settings.shows_artboard);
  read.boolean("squares", settings.shows_squares);
  read.boolean("rulers", settings.shows_rulers);
  read.boolean("desktop_dialogs", settings.uses_desktop_dialogs);
  read.number("left_panel_width", settings.panel_widths.left, kNarrowestPanels.left,
              kWidestPanels.left);
  read.number("right_panel_width", settings.panel_widths.right, kNarrowestPanels.right,
              kWidestPanels.right);
  read.number("time_line_height", settings.time_line_height, kLowestTimeLine, kHighestTimeLine);
  read.number("autosave_seconds", settings.autosave_seconds, Autosave::kShortestInterval,
              Autosave::kLongestInterval);
  read.number("window_width", settings.window_width, kLeastWindow, kLargestWindow);
  read.number("window_height", settings.window_height, kLeastWindow, kLargestWindow);
  read.boolean("maximised", settings.is_maximised);
  if (const auto theme = read.find("theme"); theme && theme->is_string())
    settings.theme = theme_named(theme->get<std::string>());
  if (const auto name = read.find("workspace"); name && name->is_string())
    settings.workspace = *name == "animate" ? Workspace::animate : Workspace::lab;
  if (read.find("pace")) read.number("pace", settings.pace.emplace(1), 1, 60);
  for (const std::string& title : read.texts("closed_sections"))
    settings.closed_sections.insert(title);
  if (read.find("closed_in_animate")) {
    const auto titles = read.texts("closed_in_animate");
    settings.closed_in_animate = {titles.begin(), titles.end()};
  }
  if (const auto* keys = read.find("keys")) {
    std::tie(settings.keys, settings.problem) = read_keys(*keys);
    if (!settings.problem.empty()) settings.problem.insert(0, file.string() + ": ");
  }
  if (const auto* layers = read.find("layers")) settings.layers = read_layers(*layers, {});
  return settings;
}

std::string settings_text(const Settings& settings) {
  nlohmann::json json{{"scale", settings.scale},
                      {"theme", kThemeNames[static_cast<std::size_t>(settings.theme)]},
                      {"panels", settings.shows_panels},
                      {"artboard", settings.shows_artboard},
                      {"squares", settings.shows_squares},
                      {"rulers", settings.shows_rulers},
                      {"desktop_dialogs", settings.uses_desktop_dialogs},
                      {"left_panel_width", settings.panel_widths.left},
                      {"right_panel_width", settings.panel_widths.right},
                      {"time_line_height", settings.time_line_height},
                      {"closed_sections", settings.closed_sections},
                      {"closed_in_animate", settings.closed_in_animate},
                      {"window_width", settings.window_width},
                      {"window_height", settings.window_height},
                      {"maximised", settings.is_maximised},
                      {"autosave_seconds", settings.autosave_seconds}};
  if (settings.workspace)
    json["workspace"] = *settings.workspace == Workspace::animate ? "animate" : "lab";
  if (settings.pace) json["pace"] = *settings.pace;
  if (settings.keys != KeyChoice{}) json["keys"] = keys_json(settings.keys);
  if (settings.layers) json["layers"] = layers_json(*settings.layers);
  return json.dump(2) + "\n";
}

void save_settings(const std::filesystem::path& file, const Settings& settings) {
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  write_file_atomically(file, settings_text(settings));
}

}  // namespace foldless
