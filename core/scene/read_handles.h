// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/scene/json_value.h"

namespace foldless {

/// The handles of a scene file. `used_vertices`: by vertex, whether a triangle has it. One without
/// an id has its place in the list as its id, or else the next free number. Throws Error
/// `FILE:LINE: ...` for what is no handle.
std::vector<Handle> read_handles(const JsonValue& handles, const std::vector<bool>& used_vertices);

}  // namespace foldless
