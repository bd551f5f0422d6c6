// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// A scene that comes with the program.
struct Sample {
  std::filesystem::path path;
  std::string title;        ///< from the file's name: `Figure 8: eta 1 percent`
  std::string description;  ///< one line on what to look at; may be empty
};

/// The scenes in the program's data, figures first; none when the data is missing.
std::vector<Sample> find_samples();

/// True for a scene that comes with the program: it is opened as a copy.
bool is_sample(const std::filesystem::path& path);

/// True for a folder of scenes, meshes or images that come with the program: nothing is to be
/// written there.
bool is_data_folder(const std::filesystem::path& folder);

/// The scene that the program opens on when it is given none.
std::filesystem::path welcome_scene();

}  // namespace foldless
