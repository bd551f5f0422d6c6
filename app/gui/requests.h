// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

#include "app/editor/editor.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// Opens the dialogs that the editor asked for; F12's picture goes beside the scene, or to
/// `pictures_folder` when the scene has no file. Returns whether there was anything to do.
bool handle_requests(Editor& editor, UiState& state, const std::filesystem::path& pictures_folder);

/// Asks for the scene that a lane of the race takes method, energy and numbers from; where it is of
/// no use the lane stays as it is, and a message says why.
void ask_for_lane_scene(std::size_t lane, Editor& editor, UiState& state);

}  // namespace foldless
