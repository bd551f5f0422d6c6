// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/motion/bake.h"

namespace foldless {

/// Steps of a baked animation, by the frame before them, that are not gone through: a program shows
/// that frame until the next one is due.
using HeldSteps = std::set<std::size_t>;

/// Those that are not proved.
inline HeldSteps held_steps(const std::vector<BakedFailure>& failures) {
  HeldSteps held;
  for (const BakedFailure& failure : failures) held.insert(failure.from);
  return held;
}

/// `1 moment jumps`, `3 moments jump`.
inline std::string jump_words(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " moment jumps" : " moments jump");
}

}  // namespace foldless
