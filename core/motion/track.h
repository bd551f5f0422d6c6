// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/triangle.h"
#include "core/motion/easing.h"

namespace foldless {

/// A value at a frame, and how it goes on from there.
template <typename Value>
struct Keyframe {
  int frame = 0;
  Value value{};
  Easing easing = {};  ///< to the next key

  bool operator==(const Keyframe&) const = default;
};

/// Keys in the order of their frames, one a frame. Before the first the value is that of the first,
/// after the last that of the last; in a cycle it goes on from the last to the first of the next
/// round.
template <typename Value>
using Track = std::vector<Keyframe<Value>>;

/// Over how many frames an animation runs, and whether it begins anew then.
struct Cycle {
  int frames = 48;
  bool loops = false;

  bool operator==(const Cycle&) const = default;
};

/// Two keys and where between them a moment is; both are one key where nothing is in between.
struct Passage {
  std::size_t from = 0, to = 0;  ///< indices of keys
  double share = 0;              ///< of the way, eased
};

/// Where a moment is among keys. Precondition: there are any; 0 ≤ frame ≤ cycle.frames.
template <typename Value>
Passage passage_at(const Track<Value>& track, double frame, const Cycle& cycle) {
  const std::size_t last = track.size() - 1;
  std::size_t next = 0;
  while (next < track.size() && track[next].frame <= frame) ++next;
  const bool is_before = next == 0, is_after = next > last;
  if (!cycle.loops && is_before) return {0, 0, 0};
  if (!cycle.loops && is_after) return {last, last, 0};
  const Passage keys{is_before ? last : next - 1, is_after ? 0 : next, 0};
  const double start = track[keys.from].frame - (is_before ? cycle.frames : 0);
  const double end = track[keys.to].frame + (is_after ? cycle.frames : 0);
  if (!(end > start)) return {keys.from, keys.from, 0};
  return {keys.from, keys.to, track[keys.from].easing.at((frame - start) / (end - start))};
}

/// The number at a moment. Precondition: as passage_at().
double value_at(const Track<double>& track, double frame, const Cycle& cycle);

/// How a point goes from key to key.
enum class PathShape {
  straight,
  smooth,  ///< a Catmull–Rom curve, centripetal [YSK11]: no cusps, no loops between two keys
  swing    ///< about a centre: distance and angle go on evenly, the shorter way round
};

struct Path {
  PathShape shape = PathShape::straight;
  Vec2 center = Vec2::Zero();  ///< of a swing
};

/// The point at a moment. Precondition: as passage_at().
Vec2 point_at(const Track<Vec2>& track, double frame, const Cycle& cycle, const Path& path);

}  // namespace foldless
