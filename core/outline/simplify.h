// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/outline/triangulate.h"

namespace foldless {

/// Leaves out corners of loops as long as no point of the loops is farther than `distance` from
/// what replaces it. Loops that do not touch themselves or each other stay so, and stay nested as
/// they are [DDS09].
std::vector<Loop> simplified(const std::vector<Loop>& loops, double distance);

}  // namespace foldless
