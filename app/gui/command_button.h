// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "app/editor/editor.h"
#include "app/gui/icons.h"

namespace foldless {

/// A square button for a row of the table of commands: greyed when the command is, tinted while a
/// switch is on, with title and key as tooltip.
void command_button(std::string_view command, Icon icon, Editor& editor, const Look& look);

}  // namespace foldless
