// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/motion/bake.h"

namespace foldless {

/// `triangle 12 has no area at frame 3.5`
std::string words_of(const BakedFailure& failure, const BakedAnimation& animation);

}  // namespace foldless
