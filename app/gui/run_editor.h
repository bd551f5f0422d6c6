// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/gui/session_file.h"

namespace foldless {

/// What the window opens on: the file that was named, where it is a sample as a copy; else nothing,
/// which is the start screen, where one of the recent files is there; else the sample that invites
/// a drag.
SessionStart opened_first(const std::optional<std::filesystem::path>& file,
                          const std::vector<std::filesystem::path>& recent);

/// Opens the window on opened_first(), and runs until it is closed. Returns the exit status. Throws
/// Error when there is no display. Writes the time of every frame to the file that
/// $FOLDLESS_FRAME_LOG names, see frame_log.h. With a `record` that is not empty what the user does
/// is written there, see session_file.h; the editor then has the settings of a new user and keeps
/// nothing on disk.
int run_editor(const std::optional<std::filesystem::path>& file,
               const std::filesystem::path& record = {});

}  // namespace foldless
