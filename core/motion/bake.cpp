// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/bake.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/motion/refine_bake.h"

namespace foldless {
namespace {

/// The vertices may become so many times those that the frames alone need.
constexpr double kMostForStates = 1.5;

/// Of a bake: to put its frames in, and to refine its mesh for them. To prove the steps is the
/// rest.
constexpr double kShareOfFrames = 0.1, kShareOfMesh = 0.6;

/// Tells what is done, never less than before.
class SharesDone {
 public:
  explicit SharesDone(const BakeProgress& told) : told_(told) {}
  void tell(double share) {
    if (share > most_) told_(most_ = std::min(share, 1.0));
  }

 private:
  const BakeProgress& told_;
  double most_ = 0;
};

/// The states after frames that were asked for.
using KnownStates = std::map<std::size_t, std::vector<std::shared_ptr<const Snapshot>>>;

/// The frames in order while states are put in between.
class Baking {
 public:
  /// No states are put in after `hopeless` frames. What it is given has to outlive it.
  Baking(const FramesToBake& frames, const BakeOptions& options,
         const std::set<std::size_t>& hopeless, KnownStates& between, SharesDone& shares)
      : frames_(frames),
        shares_(shares),
        options_(options),
        hopeless_(hopeless),
        between_(between),
        refined_(frames.original, frames.snapshots.front()->rest->leftCols(
                                      frames.snapshots.front()->original_vertices)) {}

  bool run(const StatesBetween& states_between, const std::stop_token& token) {
    for (std::size_t i = 0; i < frames_.snapshots.size(); ++i) {
      if (token.stop_requested()) return false;
      order_.push_back({i, 0, refined_.add_frame(frames_.snapshots[i])});
      shares_.tell(kShareOfFrames * static_cast<double>(i + 1) /
                   static_cast<double>(frames_.snapshots.size()));
    }
    double most = options_.vertex_limit * frames_.snapshots.front()->original_vertices;
    const auto tell = [this](double share) { shares_.tell(kShareOfFrames + kShareOfMesh * share); };
    if (!refine(most, token, tell)) return false;
    most = std::min(most, kMostForStates * refined_.mesh().vertex_count());
    while (true) {
      unproved_.clear();
      bool has_parted = false;
      std::vector<std::size_t> steps;
      for (const std::size_t step : steps_to_part()) {
        unproved_.insert(order_[step].frame);
        if (!hopeless_.contains(order_[step].frame)) steps.push_back(step);
      }
      tell_of_steps();
      is_full_ = refined_.mesh().vertex_count() >= most;
      if (is_full_) return true;
      // From the last on, so that the places of the others stay.
      for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        if (!find_between(order_[*step].frame, states_between)) return false;
        has_parted = part(*step) || has_parted;
      }
      if (!has_parted) return true;
      if (!refine(most, token, [](double) {})) return false;
    }
  }

  /// Frames to do without states after, if it is tried anew: where the states took too many
  /// vertices, or the mesh off the solver's map, those whose ways they do not prove; all where they
  /// do.
  std::set<std::size_t> in_vain() const {
    std::set<std::size_t> with_states, unproved;
    const bool is_near = refined_.deviation() <= options_.tolerance;
    if (is_near && (!is_full_ || failures_of(result()).empty())) return {};
    for (const Entry& entry : order_) {
      if (entry.state == 0) continue;
      with_states.insert(entry.frame);
      if (unproved_.contains(entry.frame)) unproved.insert(entry.frame);
    }
    return unproved.empty() ? with_states : unproved;
  }

  /// Takes the frames out, so that they are not there twice.
  BakedAnimation take_result() {
    BakedAnimation animation = without_frames();
    for (const Entry& entry : order_)
      animation.frames.push_back({moment_of(entry), refined_.take_deformed(entry.number)});
    return animation;
  }

 private:
  /// A frame, or a state between it and the next.
  struct Entry {
    std::size_t frame;
    std::size_t state;   ///< 0: the frame itself; else one more than its index in `between_`
    std::size_t number;  ///< in `refined_`
  };

  BakedAnimation without_frames() const {
    BakedAnimation animation;
    animation.triangles = refined_.mesh().triangles();
    animation.rest = refined_.mesh().rest();
    animation.original_vertices = frames_.snapshots.front()->original_vertices;
    animation.loops = frames_.loops;
    animation.cycle_frames = frames_.cycle_frames;
    animation.fps = frames_.fps;
    animation.deviation = refined_.deviation();
    return animation;
  }

  BakedAnimation result() const {
    BakedAnimation animation = without_frames();
    for (const Entry& entry : order_)
      animation.frames.push_back({moment_of(entry), refined_.deformed(entry.number)});
    return animation;
  }

  bool refine(double most, const std::stop_token& token, const BakeProgress& progress) {
    return refined_.refine(options_.tolerance, static_cast<int>(std::min(most, 1e9)), progress,
                           token);
  }

  /// Those that are proved.
  void tell_of_steps() {
    const double unproved =
        static_cast<double>(unproved_.size()) / static_cast<double>(frames_.snapshots.size());
    shares_.tell(1 - (1 - kShareOfFrames - kShareOfMesh) * unproved);
  }

  /// States are evenly spaced between their frames.
  double moment_of(const Entry& entry) const {
    const double start = frames_.moments[entry.frame];
    if (entry.state == 0) return start;
    const double end = entry.frame + 1 < frames_.moments.size() ? frames_.moments[entry.frame + 1]
                                                                : frames_.cycle_frames;
    const auto count = static_cast<double>(between_.at(entry.frame).size() + 1);
    return start + static_cast<double>(entry.state) / count * (end - start);
  }

  /// The steps that are not proved, by the entry that they begin with.
  std::vector<std::size_t> steps_to_part() const {
    std::vector<std::size_t> steps;
    const MotionProof proof(refined_.mesh().triangles(), refined_.mesh().vertex_count());
    for (std::size_t i = 0; i + (frames_.loops ? 0 : 1) < order_.size(); ++i) {
      const Points from = refined_.deformed(order_[i].number);
      const Points to = refined_.deformed(order_[(i + 1) % order_.size()].number);
      const auto failure = proof.first_failure(from, to);
      if (failure && failure->moment > 0) steps.push_back(i);
    }
    return steps;
  }

  bool find_between(std::size_t frame, const StatesBetween& states_between) {
    if (between_.contains(frame)) return true;
    auto states = states_between(frame);
    if (!states) return false;
    between_[frame] = std::move(*states);
    return true;
  }

  /// Puts the state in the middle of a step into it; false where there is none.
  bool part(std::size_t step) {
    const auto [frame, first, number] = order_[step];
    const bool ends_inside = step + 1 < order_.size() && order_[step + 1].frame == frame;
    const auto& states = between_.at(frame);
    const std::size_t last = ends_inside ? order_[step + 1].state : states.size() + 1;
    const std::size_t middle = (first + last) / 2;
    if (middle == first) return false;
    const std::size_t added = refined_.add_frame(states[middle - 1]);
    order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(step) + 1, {frame, middle, added});
    return true;
  }

  const FramesToBake& frames_;
  SharesDone& shares_;
  const BakeOptions& options_;
  const std::set<std::size_t>& hopeless_;
  KnownStates& between_;
  RefineBake refined_;
  std::vector<Entry> order_;
  std::set<std::size_t> unproved_;  ///< frames with a step after them that is not
  bool is_full_ = false;            ///< there is no room for more vertices
};

}  // namespace

std::optional<BakedAnimation> bake(const FramesToBake& frames, const BakeOptions& options,
                                   const StatesBetween& states_between,
                                   const std::stop_token& token) {
  std::set<std::size_t> hopeless;
  KnownStates between;
  SharesDone shares(options.progress);
  while (true) {
    Baking baking(frames, options, hopeless, between, shares);
    if (!baking.run(states_between, token)) return std::nullopt;
    const std::set<std::size_t> in_vain = baking.in_vain();
    if (in_vain.empty()) {
      shares.tell(1);
      return baking.take_result();
    }
    hopeless.insert(in_vain.begin(), in_vain.end());
  }
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
