// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace foldless {

/// What an animation can be written as. A row of the one table that the command line and the export
/// dialog choose from.
struct AnimationFormat {
  enum class Kind {
    film,      ///< pictures in one file, see Film
    video,     ///< pictures in one file that the program ffmpeg makes
    sheet,     ///< pictures on one, with a file that tells where
    folder,    ///< a picture a file
    gltf,      ///< baked, as the following: the mesh and its vertices' places over time
    spine,     ///< and two files beside it
    godot,     ///< and pictures beside it
    foldless,  ///< with the proof, read back by `check`
  };
  Kind kind;
  std::string_view ending;  ///< of the file's name; empty: a folder
  std::string_view words;   ///< what it is, for a list

  /// A mesh that moves instead of pictures.
  bool is_baked() const { return kind >= Kind::gltf; }
};

std::span<const AnimationFormat> animation_formats();

/// By the ending of a name, of two that fit the longer; null when it has another.
const AnimationFormat* find_animation_format(const std::filesystem::path& path);

/// `.png, .gif ... or a folder of pictures`.
std::string animation_endings();

/// `walk` of `walk.spine.json`.
std::string name_without_ending(const std::filesystem::path& path, const AnimationFormat& format);

}  // namespace foldless
