// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/mesh/injective.h"

namespace foldless {

/// What is wrong with a map, as the verdict of a method that met its own conditions: `12 triangles
/// folded`, `fold-free but 7 interior vertices wind twice`, or nothing.
std::string words_on(const InjectivityReport& report);

}  // namespace foldless
