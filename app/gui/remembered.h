// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/editor.h"
#include "app/gui/settings.h"

namespace foldless {

/// Gives an editor in which nothing was opened yet what the user had the last time, and says what
/// of the settings is of no use.
void bring_back(const Settings& settings, Editor& editor);

/// Keeps in the settings what the user changes in the editor.
void remember(const Editor& editor, Settings& settings);

}  // namespace foldless
