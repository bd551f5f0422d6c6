// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/rig/rig.h"
#include "core/scene/json_value.h"

namespace foldless {

/// The bones of a scene file. Throws Error `FILE:LINE: ...` for chains of less than two joints, and
/// for joints that are no ids of handles or are named twice.
std::vector<Bones> read_bones(const JsonValue& bones, const std::vector<Handle>& handles);
JsonNode bones_node(const std::vector<Bones>& bones);

/// The mirror of a scene file. Throws Error `FILE:LINE: ...` where its two points are one.
Mirror read_mirror(const JsonValue& mirror);
JsonNode mirror_node(const Mirror& mirror);

}  // namespace foldless
