// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/gui/extent.h"

namespace foldless {

/// How a session is replayed.
struct ReplayOptions {
  std::filesystem::path session;
  std::filesystem::path shots;      ///< folder for the pictures, made if need be
  std::optional<Extent> size = {};  ///< of the window, in place of the session's [pixels]
};

/// Plays a session in the whole editor off screen, with the settings that a new user has, and
/// writes a picture of the window at every `shot`. Every event waits until the editor has come to
/// rest, so that the pictures do not depend on how fast the machine is. Files that the session
/// saved are saved again. Returns how many pictures were written. Throws Error `FILE:LINE: ...`.
int replay_session(const ReplayOptions& options);

}  // namespace foldless
