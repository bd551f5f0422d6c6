// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/gui/extent.h"
#include "render/image.h"
#include "render/view_options.h"

namespace foldless {

class Editor;
class Ui;

/// How a session is replayed.
struct ReplayOptions {
  std::filesystem::path session;
  std::filesystem::path shots;      ///< folder for the pictures, made if need be
  std::optional<Extent> size = {};  ///< of the window, in place of the session's [pixels]
};

/// The whole editor as a new user sees it when the file has been opened and all has come to rest:
/// a picture of a window of `size` [pixels]. Throws Error where the file cannot be opened, or a
/// window cannot have that size.
Image picture_of_editor(const std::filesystem::path& file, Extent size, std::optional<Theme> theme);

/// Something goes on that will change the picture by itself, and then end.
bool is_busy(const Editor& editor, const Ui& ui);

/// Plays a session in the whole editor off screen, with the settings that a new user has, and
/// writes a picture of the window at every `shot`. Every event waits until the editor has come to
/// rest, so that the pictures do not depend on how fast the machine is. Files that the session
/// saved are saved again. Returns how many pictures were written. Throws Error `FILE:LINE: ...`.
int replay_session(const ReplayOptions& options);

}  // namespace foldless
