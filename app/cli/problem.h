// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/method/method.h"
#include "core/scene/scene_io.h"
#include "render/texture_pieces.h"

namespace foldless {

/// A scene file with the methods of this program, or an OBJ file with handles.txt beside it; throws
/// Error.
LoadedScene load_scene_file(const std::filesystem::path& file);

/// What a scene starts from: its state where it has one, else its mesh at rest.
Problem problem_of(const Scene& scene);

/// What frame 0 of the scene's animation starts from: its mesh at rest. Where handles hold vertices
/// that came from splits it is that of the state.
Problem problem_at_rest(const Scene& scene);

/// The texture of a mesh with these parts; prints a note on what of it is missing. Throws Error.
std::shared_ptr<const TexturePieces> read_texture(const std::filesystem::path& file,
                                                  const std::shared_ptr<const MeshParts>& parts);

/// Does something with what came from a file; an Error of that names the file.
template <typename Task>
auto naming(const std::filesystem::path& file, const Task& task) {
  try {
    return task();
  } catch (const Error& error) {
    throw Error(file.string() + ": " + error.what());
  }
}

/// Prints `foldless: note: …` on stderr, one line each.
void print_notices(const std::vector<std::string>& notices);

}  // namespace foldless
