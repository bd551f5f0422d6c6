// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy/positions.h"

namespace foldless {

/// How handles travel from where they are to their targets.
enum class PathKind {
  straight,  ///< along lines
  turning    ///< in spirals about the common centre of turning of those that move
};

/// One path for every handle, over λ from 0 (start) to 1 (target). Straight paths of a ring that
/// turns by 180° meet in a point; turning paths do not.
class HandlePaths {
 public:
  HandlePaths(PathKind kind, const Points& starts, const Points& targets);

  Vec2 at(int handle, double lambda) const;
  /// Length of a handle's path. [length]
  double length(int handle) const { return lengths_[static_cast<std::size_t>(handle)]; }
  /// How far the handles that move turn together: the angle of the similarity that fits their
  /// motion best, in (−π, π]. [rad]
  static double common_turn(const Points& starts, const Points& targets);

 private:
  PathKind kind_;
  Points starts_, targets_;
  Vec2 centre_ = Vec2::Zero();
  std::vector<double> angles_;  ///< by which each handle turns about the centre
  std::vector<double> lengths_;
};

}  // namespace foldless
