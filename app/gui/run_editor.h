// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace foldless {

/// Opens the window on a scene, a mesh or an image, or on the built-in sample, and runs until it
/// is closed. Returns the exit status. Throws Error when there is no display. Writes the time of
/// every frame to the file that $FOLDLESS_FRAME_LOG names, see frame_log.h.
int run_editor(const std::optional<std::filesystem::path>& file);

}  // namespace foldless
