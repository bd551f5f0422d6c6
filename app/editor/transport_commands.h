// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/commands.h"

namespace foldless {

/// The rows of the menus Solve and Motion: what moves through iterations and frames.
std::vector<Command> transport_commands();

}  // namespace foldless
