// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace foldless {

/// Opens the window on a scene, a mesh or an image, or on the built-in sample, and runs until it
/// is closed. Returns the exit status. Throws Error when there is no display. Writes the time of
/// every frame to the file that $FOLDLESS_FRAME_LOG names, see frame_log.h.
/// With a `record` that is not empty what the user does is written there, see session_file.h; the
/// editor then has the settings of a new user and keeps nothing on disk.
int run_editor(const std::optional<std::filesystem::path>& file,
               const std::filesystem::path& record = {});

}  // namespace foldless
