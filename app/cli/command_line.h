// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/exit_status.h"
#include "render/image.h"
#include "render/view_options.h"

namespace foldless {

/// What needs the interface. Each may throw Error.
struct EditorCalls {
  /// Opens the editor on a scene, mesh or image, or on the built-in sample, and returns the exit
  /// status when the window was closed. Records the session in `record` unless that is empty.
  std::function<int(const std::optional<std::filesystem::path>& file,
                    const std::filesystem::path& record)>
      open = {};
  /// Replays a session off screen, in a window of `size` if given, with pictures in the folder
  /// `shots`; returns how many there are.
  std::function<int(const std::filesystem::path& session, const std::filesystem::path& shots,
                    const std::optional<std::array<int, 2>>& size)>
      replay = {};
  /// Draws the whole editor off screen, at rest on a file, in a window of `size` if given.
  std::function<Image(const std::filesystem::path& file,
                      const std::optional<std::array<int, 2>>& size, std::optional<Theme> theme)>
      picture = {};
};

/// The whole program but for the window: parses the arguments, runs the call they ask for and
/// returns its exit status. `foldless [FILE]` opens the editor; nothing else needs a display.
/// Never throws: an exception becomes one line on stderr, `foldless: FILE:LINE: what is wrong`,
/// and status 2.
int run_command_line(int argc, const char* const* argv, const EditorCalls& editor);

}  // namespace foldless
