// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/handle.h"
#include "core/motion/track.h"

namespace foldless {

/// What moves of one handle; what has no keys stays as the handle is.
struct HandleTracks {
  int handle = 0;             ///< its id
  bool is_smooth = false;     ///< a curve through the positions instead of straight lines
  Track<Vec2> position = {};  ///< of the target [length]
  Track<double> angle = {};   ///< of a handle that turns [degrees]
  Track<double> depth = {};   ///< see Handle::depth
  Track<double> weight = {};  ///< of soft handles, > 0

  bool operator==(const HandleTracks&) const = default;
};

/// Handles that swing about a centre from key to key, as an arm does about its shoulder.
struct TurningGroup {
  Vec2 center = Vec2::Zero();
  std::vector<int> handles;  ///< ids, none of them in two groups

  bool operator==(const TurningGroup&) const = default;
};

/// How the handles of a scene move.
struct Animation {
  double fps = 24;  ///< frames a second, from kLeastFps to kLargestFps
  Cycle cycle;  ///< frames 0 to frames − 1 are shown; in a loop frame `frames` is the first again
  std::vector<HandleTracks> tracks;  ///< one a handle at most
  std::vector<TurningGroup> groups;

  bool operator==(const Animation&) const = default;
};

inline constexpr double kLeastFps = 0.1, kLargestFps = 1000;
inline constexpr int kMostFrames = 100000;

/// The handles at a moment, in frames from the start: 0 ≤ frame ≤ cycle.frames.
std::vector<Handle> handles_at(const Animation& animation, std::vector<Handle> handles,
                               double frame);

/// The animation without the tracks and groups of handles that are not there.
Animation animation_of(Animation animation, const std::vector<Handle>& handles);

}  // namespace foldless
