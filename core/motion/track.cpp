// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/track.h"

#include <cmath>
#include <optional>

namespace foldless {
namespace {

/// The next key in one direction that lies elsewhere than key `i`; none at the end of a track that
/// is no cycle.
std::optional<Vec2> neighbour(const Track<Vec2>& track, std::size_t i, bool is_backwards,
                              bool loops) {
  const std::size_t n = track.size();
  std::size_t k = i;
  for (std::size_t step = 0; step < n; ++step) {
    if (!loops && k == (is_backwards ? 0 : n - 1)) return std::nullopt;
    k = (k + (is_backwards ? n - 1 : 1)) % n;
    if (track[k].value != track[i].value) return track[k].value;
  }
  return std::nullopt;
}

/// From b to c, by the pyramid of Barry and Goldman over knots at the roots of the distances.
Vec2 catmull_rom(const std::array<Vec2, 4>& points, double share) {
  std::array<double, 4> knots{};
  for (std::size_t i = 1; i < 4; ++i)
    knots[i] = knots[i - 1] + std::sqrt((points[i] - points[i - 1]).norm());
  const double t = knots[1] + share * (knots[2] - knots[1]);
  std::array<Vec2, 4> level = points;
  for (std::size_t span = 1; span < 4; ++span)
    for (std::size_t i = 0; i + span < 4; ++i) {
      // The pyramid narrows onto the middle knots: its last step is between knots 1 and 2.
      const std::size_t low = span == 3 ? 1 : i, high = span == 3 ? 2 : i + span;
      const double part = (t - knots[low]) / (knots[high] - knots[low]);
      level[i] = (1 - part) * level[i] + part * level[i + 1];
    }
  return level[0];
}

Vec2 swung(const Vec2& from, const Vec2& to, double share, const Vec2& center) {
  const Vec2 a = from - center, b = to - center;
  if (a.isZero(0) || b.isZero(0)) return (1 - share) * from + share * to;
  const double angle = share * std::atan2(cross(a, b), a.dot(b));
  const double stretch = std::pow(b.norm() / a.norm(), share);
  const Vec2 turned(std::cos(angle) * a.x() - std::sin(angle) * a.y(),
                    std::sin(angle) * a.x() + std::cos(angle) * a.y());
  return center + stretch * turned;
}

}  // namespace

double value_at(const Track<double>& track, double frame, const Cycle& cycle) {
  const Passage passage = passage_at(track, frame, cycle);
  const double from = track[passage.from].value;
  return from + passage.share * (track[passage.to].value - from);
}

Vec2 point_at(const Track<Vec2>& track, double frame, const Cycle& cycle, const Path& path) {
  const Passage passage = passage_at(track, frame, cycle);
  const Vec2& from = track[passage.from].value;
  const Vec2& to = track[passage.to].value;
  if (from == to || passage.share == 0) return from;
  if (path.shape == PathShape::swing) return swung(from, to, passage.share, path.center);
  if (path.shape == PathShape::straight) return from + passage.share * (to - from);
  const Vec2 before =
      neighbour(track, passage.from, true, cycle.loops).value_or(Vec2(2 * from - to));
  const Vec2 after = neighbour(track, passage.to, false, cycle.loops).value_or(Vec2(2 * to - from));
  return catmull_rom({before, from, to, after}, passage.share);
}

}  // namespace foldless
