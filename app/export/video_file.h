// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "app/export/film_output.h"

namespace foldless {

/// Whether there is a program ffmpeg to be started.
bool has_ffmpeg();

/// A video that the program ffmpeg makes of the pictures; the file takes its name when it is whole.
/// A .webm keeps transparency. Throws Error, here or later, where there is no ffmpeg or it fails.
std::unique_ptr<FilmOutput> video_file(const std::filesystem::path& path,
                                       const FilmOptions& options);

}  // namespace foldless
