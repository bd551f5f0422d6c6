// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/solved_bake.h"

#include <memory>

#include "core/run/adopted_pose.h"

namespace foldless {
namespace {

using States = std::vector<std::shared_ptr<const Snapshot>>;

/// What leads from a frame to the next, or from the last of a loop to where it begins anew.
std::optional<States> states_after(const Frames& frames, const std::vector<SolvedFrame>& solved,
                                   std::size_t frame, const std::stop_token& token) {
  const bool is_last = frame + 1 == solved.size();
  const double next = is_last ? frames.animation().cycle.frames : solved[frame + 1].frame;
  States states;
  const Snapshot& before = *solved[frame].snapshot;
  const auto visit = [&](const auto& state) { states.push_back(adopted_pose(state, before)); };
  if (!frames.solve(next, &before, token, visit)) return std::nullopt;
  if (!is_last && !states.empty()) states.pop_back();  // The next frame itself.
  return states;
}

}  // namespace

std::optional<BakedAnimation> bake_solved(const Frames& frames, const SolvedToBake& wanted,
                                          const std::stop_token& token) {
  const Animation& animation = frames.animation();
  FramesToBake to_bake{wanted.original,        {},           {}, wanted.loops,
                       animation.cycle.frames, animation.fps};
  for (const SolvedFrame& frame : wanted.solved) {
    to_bake.moments.push_back(frame.frame);
    to_bake.snapshots.push_back(frame.snapshot);
  }
  const auto between = [&](std::size_t frame) {
    return states_after(frames, wanted.solved, frame, token);
  };
  return bake(to_bake, {.tolerance = wanted.tolerance, .progress = wanted.progress}, between,
              token);
}

}  // namespace foldless
