// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// For every vertex of a mesh a number in [0, vertices) that is the same for two vertices exactly
/// when triangles connect them. Precondition: indices in range.
std::vector<int> components_of(const Triangles& triangles, int vertices);

}  // namespace foldless
