// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/solved_animation.h"

#include <algorithm>
#include <utility>

#include "core/run/adopted_pose.h"

namespace foldless {
namespace {

/// The largest distance between the drawing's vertices in two frames.
double largest_distance(const Snapshot& a, const Snapshot& b) {
  const int n = a.original_vertices;
  if (n == 0) return 0;
  return (a.deformed.leftCols(n) - b.deformed.leftCols(n)).colwise().norm().maxCoeff();
}

class Rounds {
 public:
  Rounds(const Frames& frames, const FramesWanted& wanted) : frames_(frames), wanted_(wanted) {}

  /// At rest, or on from what is known.
  std::optional<SolvedAnimation> first(const std::stop_token& token) {
    return go({wanted_.known, 0}, nullptr, wanted_.first_round, token);
  }
  /// From where the first came to.
  std::optional<SolvedAnimation> second(const std::stop_token& token) {
    const Snapshot start = *closing_->snapshot;
    return go(
        {}, &start, [](const SolvedFrame&) {}, token);
  }

 private:
  /// One round; frame 0 is solved from `start`. In a loop the moment after the last is solved too,
  /// which closes it.
  std::optional<SolvedAnimation> go(SolvedAnimation round, const Snapshot* start,
                                    const std::function<void(const SolvedFrame&)>& visit,
                                    const std::stop_token& token) {
    while (round.frames.size() < wanted_.moments.size()) {
      const double moment = wanted_.moments[round.frames.size()];
      const Snapshot* before = round.frames.empty() ? start : round.frames.back().snapshot.get();
      auto frame = frames_.solve(moment, before, token);
      if (!frame) return std::nullopt;
      if (before) frame->snapshot = adopted_pose(frame->snapshot, *before);
      visit(*frame);
      round.frames.push_back(std::move(*frame));
      wanted_.progress(round.frames.size(), wanted_.moments.size());
    }
    const Cycle& cycle = frames_.animation().cycle;
    if (!cycle.loops) return round;
    closing_ = frames_.solve(cycle.frames, round.frames.back().snapshot.get(), token);
    if (!closing_) return std::nullopt;
    round.gap = largest_distance(*closing_->snapshot, *round.frames.front().snapshot);
    return round;
  }

  const Frames& frames_;
  const FramesWanted& wanted_;
  std::optional<SolvedFrame> closing_;
};

}  // namespace

std::optional<SolvedAnimation> solve_animation(const Frames& frames, const FramesWanted& wanted,
                                               const std::stop_token& token) {
  Rounds rounds(frames, wanted);
  auto first = rounds.first(token);
  if (!first || first->gap <= wanted.tolerance) return first;
  auto second = rounds.second(token);
  if (!second || second->gap < first->gap) return second;
  return first;
}

double closing_tolerance(const Points& rest) {
  const Vec2 sides = rest.rowwise().maxCoeff() - rest.rowwise().minCoeff();
  return 0.25 / 1024 * sides.maxCoeff();
}

std::vector<double> moments_of(const Animation& animation, double fps) {
  const Cycle& cycle = animation.cycle;
  const double step = animation.fps / fps;
  const double end = cycle.loops ? cycle.frames - 1e-9 * step : cycle.frames - 1 + 1e-9 * step;
  std::vector<double> moments;
  for (int i = 0; i * step < end || i == 0; ++i)
    moments.push_back(std::min<double>(i * step, cycle.frames));
  return moments;
}

}  // namespace foldless
