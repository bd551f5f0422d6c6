// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "app/export/film.h"

namespace foldless {

/// Where the pictures of an animation go: a file or a new folder, whole at the end or not there.
class FilmOutput {
 public:
  FilmOutput() = default;
  virtual ~FilmOutput() = default;
  FilmOutput(const FilmOutput&) = delete;
  FilmOutput& operator=(const FilmOutput&) = delete;

  /// See Film.
  virtual bool wants_samples() const { return false; }
  virtual void sample(const Image&) {}
  virtual void add(const Image& image) = 0;
  /// Puts everything in its place.
  virtual void finish() = 0;
};

/// By the ending of a name, see animation_formats(). A sprite sheet has its picture beside it; a
/// folder has 000000.png and so on. Throws Error, here or later, where it cannot be written, and
/// for a folder that has something in it.
std::unique_ptr<FilmOutput> film_output(const std::filesystem::path& path,
                                        const FilmOptions& options);

/// The picture that a sprite sheet speaks of.
std::filesystem::path picture_of_sheet(const std::filesystem::path& path);

}  // namespace foldless
