// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/exit_status.h"

namespace foldless {

/// Opens the editor on a scene, mesh or image, or on the built-in sample, and returns the exit
/// status when the window was closed. May throw Error.
using OpenEditor = std::function<int(const std::optional<std::filesystem::path>& file)>;

/// The whole program but for the window: parses the arguments, runs the call they ask for and
/// returns its exit status. `foldless [FILE]` calls `open_editor`; nothing else needs a display.
/// Never throws: an exception becomes one line on stderr, `foldless: FILE:LINE: what is wrong`,
/// and status 2.
int run_command_line(int argc, const char* const* argv, const OpenEditor& open_editor);

}  // namespace foldless
