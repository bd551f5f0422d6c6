// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace foldless {

/// The version of scene files that is written, and the newest that is read.
inline constexpr int kSceneVersion = 1;

/// A scene from a file, and what was repaired in its mesh, one sentence each.
struct LoadedScene {
  Scene scene;
  std::vector<std::string> notices;
};

/// Reads a scene file and its mesh. `methods`: the names that `solver.method` may have. Throws
/// Error `FILE:LINE: KEY ...` for whatever is unknown, missing, out of range or not valid; the
/// state must be locally injective in rest and deformed positions.
LoadedScene load_scene(const std::filesystem::path& file,
                       std::span<const std::string_view> methods);

/// A scene of a mesh file alone: no handles, energy `arap`, default parameters. Throws Error.
LoadedScene scene_from_mesh(const std::filesystem::path& file);

/// Writes a scene file atomically; paths of the mesh and the texture are written relative to its
/// folder. Parameters at their defaults are left out. Loading and saving again gives the same
/// bytes. Throws Error.
void save_scene(const Scene& scene, const std::filesystem::path& file);

/// The text that save_scene() writes into a file of `folder` (absolute).
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);

/// Makes the paths of a scene relative to another folder (absolute), where it was saved to.
void move_to_folder(Scene& scene, const std::filesystem::path& folder);

}  // namespace foldless
