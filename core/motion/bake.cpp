// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/bake.h"

#include <algorithm>
#include <utility>

#include "core/motion/refine_bake.h"

namespace foldless {
namespace {

constexpr double kShortestStep = 1.0 / 16;  ///< of a frame

/// The frames in order while moments are put in between.
class Baking {
 public:
  Baking(const FramesToBake& frames, const BakeOptions& options)
      : frames_(frames),
        options_(options),
        refined_(frames.original, frames.snapshots.front()->rest->leftCols(
                                      frames.snapshots.front()->original_vertices)) {
    for (std::size_t i = 0; i < frames.snapshots.size(); ++i) add(i, frames.moments[i], i);
  }

  bool run(const SolveBetween& solve_between, const std::stop_token& token) {
    if (!refine(token)) return false;
    while (true) {
      const std::vector<std::size_t> steps = steps_to_halve();
      if (steps.empty()) return true;
      // From the last on, so that the places of the others stay.
      for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        if (!halve(*step, solve_between)) return false;
      if (!refine(token)) return false;
    }
  }

  BakedAnimation result() const {
    BakedAnimation animation;
    animation.triangles = refined_.mesh().triangles();
    animation.rest = refined_.mesh().rest();
    animation.original_vertices = frames_.snapshots.front()->original_vertices;
    for (const Entry& entry : order_)
      animation.frames.push_back({entry.moment, refined_.deformed(entry.number)});
    animation.loops = frames_.loops;
    animation.cycle_frames = frames_.cycle_frames;
    animation.fps = frames_.fps;
    animation.deviation = refined_.deviation();
    return animation;
  }

 private:
  struct Entry {
    double moment;
    std::size_t number;  ///< of the frame in `refined_`
  };

  void add(std::size_t place, double moment, std::size_t snapshot) {
    const std::size_t number = refined_.add_frame(frames_.snapshots[snapshot]);
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), {moment, number});
  }

  bool refine(const std::stop_token& token) {
    const double most = options_.vertex_limit * frames_.snapshots.front()->original_vertices;
    return refined_.refine(options_.tolerance, static_cast<int>(std::min(most, 1e9)), token);
  }

  /// The moment that follows an entry; that of the first comes again at the end of a loop.
  double moment_after(std::size_t step) const {
    return step + 1 < order_.size() ? order_[step + 1].moment : frames_.cycle_frames;
  }

  /// The steps, by the entry that they begin with, that are not proved and long enough.
  std::vector<std::size_t> steps_to_halve() const {
    std::vector<std::size_t> steps;
    const MotionProof proof(refined_.mesh().triangles(), refined_.mesh().vertex_count());
    for (std::size_t i = 0; i + (frames_.loops ? 0 : 1) < order_.size(); ++i) {
      if (moment_after(i) - order_[i].moment < 2 * kShortestStep) continue;
      const Points from = refined_.deformed(order_[i].number);
      const Points to = refined_.deformed(order_[(i + 1) % order_.size()].number);
      const auto failure = proof.first_failure(from, to);
      if (failure && failure->moment > 0) steps.push_back(i);
    }
    return steps;
  }

  bool halve(std::size_t step, const SolveBetween& solve_between) {
    const double moment = 0.5 * (order_[step].moment + moment_after(step));
    auto snapshot = solve_between(moment, refined_.map(order_[step].number).snapshot());
    if (!snapshot) return false;
    frames_.snapshots.push_back(std::move(snapshot));
    add(step + 1, moment, frames_.snapshots.size() - 1);
    return true;
  }

  FramesToBake frames_;
  BakeOptions options_;
  RefineBake refined_;
  std::vector<Entry> order_;
};

}  // namespace

std::optional<BakedAnimation> bake(const FramesToBake& frames, const BakeOptions& options,
                                   const SolveBetween& solve_between,
                                   const std::stop_token& token) {
  Baking baking(frames, options);
  if (!baking.run(solve_between, token)) return std::nullopt;
  return baking.result();
}

std::vector<BakedFailure> failures_of(const BakedAnimation& animation) {
  std::vector<BakedFailure> failures;
  const MotionProof proof(animation.triangles, static_cast<int>(animation.rest.cols()));
  const std::size_t count = animation.frames.size();
  for (std::size_t i = 0; i + (animation.loops ? 0 : 1) < count; ++i) {
    const Points& to = animation.frames[(i + 1) % count].deformed;
    if (const auto failure = proof.first_failure(animation.frames[i].deformed, to))
      failures.push_back({i, *failure});
  }
  if (count == 1 && !animation.loops) {
    const Points& only = animation.frames.front().deformed;
    if (const auto failure = proof.first_failure(only, only)) failures.push_back({0, *failure});
  }
  return failures;
}

}  // namespace foldless
