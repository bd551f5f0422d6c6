// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "core/run/frames.h"
#include "core/run/latest_job.h"

namespace foldless {

/// Solves a moment between two frames on a thread of its own, from the frame before it; of several
/// that are asked for the last counts. `wake` is called on that thread when it is solved; it must
/// neither block nor throw.
class BackgroundMoment {
 public:
  explicit BackgroundMoment(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

  /// The moment as a state of the solver; null while it is not solved, or cannot be. Of the same
  /// frame and moment it is solved once.
  std::shared_ptr<const SolvedFrame> at(double moment,
                                        const std::shared_ptr<const SolvedFrame>& before,
                                        const std::shared_ptr<const Frames>& frames);

 private:
  std::function<void()> wake_;
  double moment_ = 0;                          ///< that was asked for last
  std::shared_ptr<const SolvedFrame> before_;  ///< of that
  std::mutex mutex_;                           ///< of what follows
  std::shared_ptr<const SolvedFrame> solved_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
