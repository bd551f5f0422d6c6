// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/run/solved_animation.h"

namespace foldless {

/// What is to be solved.
struct AnimationToSolve {
  Problem at_rest;  ///< what frame 0 is solved from
  Animation animation;
  double tolerance = 0;  ///< of the gap of a loop [length]
};

/// How far the frames of an animation are.
struct FramesStatus {
  std::size_t count = 0;      ///< frames that there will be
  std::size_t solved = 0;     ///< the first of them that there are
  std::size_t injective = 0;  ///< of these, at the boundary too
  int round = 1;              ///< 2 while a loop is gone through once more
  bool is_done = false;       ///< no frame will change any more
  std::optional<double> gap;  ///< of a loop, as soon as it is done; see SolvedAnimation
  std::string error;          ///< one sentence where it could not go on, else empty
};

/// Solves the frames of an animation on a thread of its own, in order, and keeps them: the same
/// that solve_animation() returns. After a change those before the first moment at which a handle
/// differs stay, and those that follow from the same as one that was solved before come back. All
/// functions may be called from one other thread and return at once. `wake` is called on the own
/// thread when there is news; it must neither block nor throw.
class BackgroundFrames {
 public:
  explicit BackgroundFrames(std::function<void()> wake = {});
  ~BackgroundFrames();  ///< cancels and joins
  BackgroundFrames(const BackgroundFrames&) = delete;
  BackgroundFrames& operator=(const BackgroundFrames&) = delete;

  void solve(AnimationToSolve wanted);
  /// No animation.
  void clear();
  /// While held it rests, as the processor has better to do.
  void hold(bool is_held);

  /// The frame of that number, or null while it is not solved. In a loop that is not done yet it
  /// may be solved once more.
  std::shared_ptr<const SolvedFrame> frame(std::size_t index) const;
  FramesStatus status() const;

 private:
  /// What one look at what is wanted came to.
  struct Task {
    Frames frames;
    FramesWanted wanted;
    std::stop_token token;
  };

  void work(const std::stop_token& stopping);
  /// With the lock held.
  Task begin_task();
  void note_round(int round, const std::stop_token& token);
  void solve_all(Task& task);

  const std::function<void()> wake_;
  mutable std::mutex mutex_;  ///< guards what follows but the thread
  std::condition_variable_any changed_;
  std::optional<AnimationToSolve> wanted_;
  std::vector<std::shared_ptr<const SolvedFrame>> first_round_;
  std::vector<std::shared_ptr<const SolvedFrame>> done_;  ///< empty while it goes on
  /// Solved from the same start; of the own thread, but for being replaced.
  std::shared_ptr<SolvedBefore> before_ = std::make_shared<SolvedBefore>();
  double gap_ = 0;
  int round_ = 1;
  std::string error_;
  bool is_held_ = false;
  std::stop_source running_;
  std::jthread thread_;  ///< last, so that it is joined before anything else goes
};

}  // namespace foldless
