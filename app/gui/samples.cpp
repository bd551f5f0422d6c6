// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/samples.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/data_path.h"
#include "core/error.h"

namespace foldless {
namespace {

std::string title_of(const std::filesystem::path& file) {
  std::string title = file.stem().string();
  std::ranges::replace(title, '-', ' ');
  std::ranges::replace(title, '_', ' ');
  if (!title.empty())
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title;
}

std::string description_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  const auto it = json.is_object() ? json.find("description") : json.end();
  return it != json.end() && it->is_string() ? it->get<std::string>() : "";
}

}  // namespace

std::vector<Sample> find_samples() {
  std::vector<Sample> samples;
  std::filesystem::path folder;
  try {
    folder = data_path("assets/scenes");
  } catch (const Error&) {
    return samples;
  }
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".json")
      samples.push_back({entry.path(), title_of(entry.path()), description_of(entry.path())});
  std::ranges::sort(samples, {}, &Sample::title);
  return samples;
}

std::filesystem::path welcome_scene() { return data_path("assets/scenes/welcome.json"); }

}  // namespace foldless
