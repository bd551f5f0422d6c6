// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foldless {

/// True for what stands for several scenes: a folder, or a .txt file, a list of them.
bool are_scenes(const std::filesystem::path& path);

/// The scene files that the arguments name: a folder stands for the .json files in it by name, then
/// for its input.obj where that has handles.txt beside it, and a .txt file for the scenes in its
/// lines, as seen from its folder. Throws Error where there is none.
std::vector<std::filesystem::path> scene_files(const std::vector<std::filesystem::path>& named);

/// What a scene is called: its file without the ending, or the folder of an OBJ file with
/// handles.txt.
std::string name_of_scene(const std::filesystem::path& file);

}  // namespace foldless
