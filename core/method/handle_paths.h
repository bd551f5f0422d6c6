// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "core/mesh/triangle.h"

namespace foldless {

/// How handles travel from where they are to their targets. Straight paths of a ring that turns by
/// 180° meet in a point; the others do not.
enum class PathKind {
  straight,  ///< along lines
  similar,   ///< together along the similarity z ↦ a z + b that is nearest to the motion of those
             ///< that move: a^λ grows and turns, what is left goes straight
  turning    ///< each in a spiral of its own about the fixed point of that similarity
};

/// One path for every handle, over λ from 0 (start) to 1 (target).
class HandlePaths {
 public:
  /// Both are 2 × #handles. Straight where there is nothing to turn or no fixed point.
  HandlePaths(PathKind kind, Points starts, Points targets);

  /// Where a handle is at λ in [0, 1]; the target bit for bit at 1.
  Vec2 at(int handle, double lambda) const;
  /// All of them, 2 × #handles.
  Points at(double lambda) const;
  /// Length of a handle's path. [length]
  double length(int handle) const;
  PathKind kind() const { return kind_; }

 private:
  void find_turns();

  PathKind kind_;
  Points starts_, targets_;
  std::complex<double> a_ = 1;      ///< of the similarity
  Vec2 start_centre_, end_centre_;  ///< of the handles that move; of turning ones the fixed point
  std::vector<double> angles_;      ///< by which each handle turns about it
};

/// How the handles that move turn together: by the similarity that fits their motion best.
struct CommonTurn {
  double angle = 0;  ///< in (−π, π] [rad]
  double left = 0;   ///< part of their ways that it leaves, in the root of the sum of squares
  int moving = 0;    ///< how many move
};

/// Both are 2 × #handles.
CommonTurn common_turn(const Points& starts, const Points& targets);

}  // namespace foldless
