// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/files/polygon_soup.h"
#include "core/scene/json_value.h"

namespace foldless {

/// The triangles of two arrays of a JSON file, `[[x, y], …]` and `[[a, b, c], …]`, which knows the
/// lines that they come from; `part` stands before what is wrong with them. Throws Error.
TriangleSoup read_inline_triangles(const JsonValue& vertices, const JsonValue& triangles,
                                   const std::string& file, std::string part);

}  // namespace foldless
