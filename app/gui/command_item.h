// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/commands.h"
#include "app/editor/editor.h"

namespace foldless {

/// A line of a menu that runs a command: its title and its key, dim while it is not available.
void draw_command_item(const Command& command, Editor& editor);

}  // namespace foldless
