// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/commands.h"

namespace foldless {

/// The rows of commands(): the one place that names what a user can ask for.
std::vector<Command> command_table();

}  // namespace foldless
