// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

namespace foldless {

/// Exit statuses of every call.
inline constexpr int kExitDone = 0;          ///< done, and every handle satisfied
inline constexpr int kExitNotSatisfied = 1;  ///< ran to its end, but not so; results are written
/// Bad input or usage, and nothing was written; or what was printed did not arrive.
inline constexpr int kExitBadInput = 2;
inline constexpr int kExitInterrupted = 130;  ///< interrupted; the last valid mesh is written

/// Opens the editor on a scene, mesh or image, or on the built-in sample, and returns the exit
/// status when the window was closed. May throw Error.
using OpenEditor = std::function<int(const std::optional<std::filesystem::path>& file)>;

/// The whole program but for the window: parses the arguments, runs the call they ask for and
/// returns its exit status. `foldless [FILE]` calls `open_editor`; nothing else needs a display.
/// Never throws: an exception becomes one line on stderr, `foldless: FILE:LINE: what is wrong`,
/// and status 2.
int run_command_line(int argc, const char* const* argv, const OpenEditor& open_editor);

}  // namespace foldless
