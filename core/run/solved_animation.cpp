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
    const auto start = closing_->snapshot;
    number_ = 2;
    return go(
        {}, start, [](const SolvedFrame&) {}, token);
  }

 private:
  /// One round; frame 0 is solved from `start`. In a loop the moment after the last is solved too,
  /// which closes it.
  std::optional<SolvedAnimation> go(SolvedAnimation round,
                                    const std::shared_ptr<const Snapshot>& start,
                                    const std::function<void(const SolvedFrame&)>& visit,
                                    const std::stop_token& token) {
    while (round.frames.size() < wanted_.moments.size()) {
      const double moment = wanted_.moments[round.frames.size()];
      auto frame = next(moment, round.frames.empty() ? start : round.frames.back().snapshot, token);
      if (!frame) return std::nullopt;
      visit(*frame);
      round.frames.push_back(std::move(*frame));
      wanted_.progress(round.frames.size(), wanted_.moments.size(), number_);
    }
    const Cycle& cycle = frames_.animation().cycle;
    if (!cycle.loops) return round;
    closing_ = next(cycle.frames, round.frames.back().snapshot, token);
    if (!closing_) return std::nullopt;
    round.gap = largest_distance(*closing_->snapshot, *round.frames.front().snapshot);
    return round;
  }

  /// A moment from the frame before it, unless that was solved in the same way before.
  std::optional<SolvedFrame> next(double moment, const std::shared_ptr<const Snapshot>& before,
                                  const std::stop_token& token) {
    std::vector<Handle> handles = frames_.handles(moment);
    if (wanted_.before)
      if (const auto* known = wanted_.before->find(moment, before.get(), handles)) return *known;
    auto frame = frames_.solve(moment, before.get(), token);
    if (frame && before) frame->snapshot = adopted_pose(frame->snapshot, *before);
    if (frame && wanted_.before) wanted_.before->add(before, std::move(handles), *frame);
    return frame;
  }

  const Frames& frames_;
  const FramesWanted& wanted_;
  std::optional<SolvedFrame> closing_;
  int number_ = 1;  ///< of the round
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

double usual_pixel(const Points& rest) {
  const Vec2 sides = rest.rowwise().maxCoeff() - rest.rowwise().minCoeff();
  return sides.maxCoeff() / 1024;
}

double closing_tolerance(const Points& rest) { return 0.25 * usual_pixel(rest); }

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
