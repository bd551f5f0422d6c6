// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/run/latest_job.h"
#include "core/run/solved_bake.h"

namespace foldless {

/// What a bake came to.
struct BakeResult {
  BakedAnimation baked;
  std::optional<BakedFailure> failure;  ///< the first moment that is not proved
  std::string error;                    ///< one sentence where it could not be made; else empty
};

/// Bakes the frames of an animation on a thread of its own. Functions return at once. `wake` is
/// called on that thread when there is news; it must neither block nor throw.
class BackgroundBake {
 public:
  explicit BackgroundBake(std::function<void()> wake = {}) : wake_(std::move(wake)) {}

  /// Drops what was begun before.
  void start(std::shared_ptr<const Frames> frames, SolvedToBake wanted);
  /// Forgets the result, or what would become one.
  void cancel();
  /// Null while there is none.
  std::shared_ptr<const BakeResult> result() const;

 private:
  std::function<void()> wake_;
  mutable std::mutex mutex_;  ///< of what follows
  std::uint64_t number_ = 0;  ///< of the bake that is wanted
  std::shared_ptr<const BakeResult> result_;
  LatestJob job_;  ///< the last member: it ends before what it uses
};

}  // namespace foldless
