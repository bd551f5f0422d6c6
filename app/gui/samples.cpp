// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/samples.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <climits>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/data_path.h"
#include "core/error.h"

namespace foldless {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// `figure8_eta_1_percent` → `Figure 8: eta 1 percent`.
std::string title_of(const std::filesystem::path& file) {
  std::string title = file.stem().string();
  std::ranges::replace(title, '_', ' ');
  if (title.empty()) return title;
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  if (!title.starts_with("Figure") || title.size() < 7 || !is_digit(title[6])) return title;
  const auto space = std::min(title.find(' '), title.size());
  std::string figure = "Figure ";
  figure.append(title, 6, space - 6);
  if (space == title.size()) return figure;
  figure.append(":").append(title, space);
  return figure;
}

/// Drawings to pose come first, then figures by number, then everything else by title.
bool comes_before(const Sample& a, const Sample& b) {
  static constexpr std::array kDrawings{"welcome", "figure10_alligator", "figure10_cowboy"};
  const auto place = [](const Sample& sample) {
    const auto drawing = std::ranges::find(kDrawings, sample.path.stem().string());
    if (drawing != kDrawings.end()) return static_cast<int>(drawing - kDrawings.end());
    return sample.title.starts_with("Figure ") ? std::atoi(sample.title.c_str() + 7) : INT_MAX;
  };
  return std::pair(place(a), a.title) < std::pair(place(b), b.title);
}

/// Empty when the program's data is missing.
std::filesystem::path data_folder(std::string_view relative) {
  try {
    return data_path(relative);
  } catch (const Error&) {
    return {};
  }
}

std::filesystem::path samples_folder() { return data_folder("assets/scenes"); }

std::string description_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  const auto json = nlohmann::json::parse(in, nullptr, false);
  const auto it = json.is_object() ? json.find("description") : json.end();
  return it != json.end() && it->is_string() ? it->get<std::string>() : "";
}

}  // namespace

std::vector<Sample> find_samples() {
  std::vector<Sample> samples;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(samples_folder(), ignored))
    if (entry.path().extension() == ".json")
      samples.push_back({entry.path(), title_of(entry.path()), description_of(entry.path())});
  std::ranges::sort(samples, comes_before);
  return samples;
}

bool is_sample(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::equivalent(path.parent_path(), samples_folder(), ignored);
}

bool is_data_folder(const std::filesystem::path& folder) {
  static constexpr std::array<std::string_view, 3> kFolders{"assets/scenes", "assets/meshes",
                                                            "assets/images"};
  std::error_code ignored;
  return std::ranges::any_of(kFolders, [&](std::string_view data) {
    return std::filesystem::equivalent(folder, data_folder(data), ignored);
  });
}

std::filesystem::path welcome_scene() { return data_path("assets/scenes/welcome.json"); }

}  // namespace foldless
