// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/editor.h"
#include "app/gui/glyphs.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// Takes note of the characters of all that may be shown and is none of the program's own words:
/// names of files and folders, what scenes say of themselves, messages that repeat them.
void need_names(Glyphs& glyphs, const Editor& editor, const UiState& state);

}  // namespace foldless
