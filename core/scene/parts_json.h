// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/parts.h"
#include "core/scene/json_value.h"

namespace foldless {

/// The parts of a scene file, of the original mesh. Throws Error `FILE:LINE: ...` where they do not
/// follow one another over all its vertices, or a triangle lies in two.
MeshParts read_parts(const JsonValue& parts, const Triangles& triangles, int vertices);

/// The same as JSON.
JsonNode parts_node(const MeshParts& parts);

}  // namespace foldless
