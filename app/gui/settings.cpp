// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/settings.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/editor/autosave.h"

namespace foldless {
namespace {

constexpr std::array kThemeNames{"dark", "light", "contrast"};  // in the order of Theme

Theme theme_named(const std::string& name) {
  const auto found = std::ranges::find(kThemeNames, name);
  return found == kThemeNames.end() ? Theme::dark : static_cast<Theme>(found - kThemeNames.begin());
}

}  // namespace

Settings load_settings(const std::filesystem::path& file) {
  Settings settings;
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return settings;
  if (const auto it = json.find("scale"); it != json.end() && it->is_number())
    settings.scale = std::clamp(it->get<double>(), kSmallestScale, kLargestScale);
  if (const auto it = json.find("theme"); it != json.end() && it->is_string())
    settings.theme = theme_named(it->get<std::string>());
  if (const auto it = json.find("panels"); it != json.end() && it->is_boolean())
    settings.shows_panels = it->get<bool>();
  if (const auto it = json.find("autosave_seconds"); it != json.end() && it->is_number())
    settings.autosave_seconds =
        std::clamp(it->get<double>(), Autosave::kShortestInterval, Autosave::kLongestInterval);
  return settings;
}

void save_settings(const std::filesystem::path& file, const Settings& settings) {
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  const nlohmann::json json{{"scale", settings.scale},
                            {"theme", kThemeNames[static_cast<std::size_t>(settings.theme)]},
                            {"panels", settings.shows_panels},
                            {"autosave_seconds", settings.autosave_seconds}};
  std::ofstream(file) << json.dump(2) << '\n';
}

}  // namespace foldless
