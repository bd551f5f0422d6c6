// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/motion/animation.h"
#include "core/scene/json_value.h"

namespace foldless {

/// The animation of a scene file. Throws Error `FILE:LINE: ...` for keys that are not in the order
/// of their frames or not within the cycle, for handles that are not there or are named twice, and
/// for angles of handles that do not turn.
Animation read_animation(const JsonValue& animation, const std::vector<Handle>& handles);
JsonNode animation_node(const Animation& animation);

}  // namespace foldless
