// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/motion/bake.h"
#include "core/run/frames.h"

namespace foldless {

/// Solved frames that are to be baked.
struct SolvedToBake {
  Triangles original;               ///< the drawing's mesh, 3 × #F
  std::vector<SolvedFrame> solved;  ///< ascending, not empty
  bool loops = false;               ///< the step from the last to the first counts too
  double tolerance = 0;             ///< see BakeOptions [length]
  BakeProgress progress = [](double) {};
};

/// Bakes them; what is needed between two frames is solved by `frames`. Nothing when the token was
/// set. Throws Error as Run.
std::optional<BakedAnimation> bake_solved(const Frames& frames, const SolvedToBake& wanted,
                                          const std::stop_token& token);

}  // namespace foldless
