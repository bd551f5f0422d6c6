// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_bake.h"

#include <utility>

#include "core/error.h"
#include "core/run/thread_priority.h"

namespace foldless {
namespace {

/// Nothing when the token was set.
std::shared_ptr<const BakeResult> proved_bake(const Frames& frames, const SolvedToBake& wanted,
                                              const std::stop_token& token) {
  auto result = std::make_shared<BakeResult>();
  try {
    auto baked = bake_solved(frames, wanted, token);
    if (!baked) return nullptr;
    result->baked = std::move(*baked);
    const std::vector<BakedFailure> failures = failures_of(result->baked);
    if (!failures.empty()) result->failure = failures.front();
  } catch (const Error& error) {
    result->error = error.what();
  }
  return result;
}

}  // namespace

void BackgroundBake::start(std::shared_ptr<const Frames> frames, SolvedToBake wanted) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = ++number_;
    result_ = nullptr;
  }
  job_.start([this, number, frames = std::move(frames),
              wanted = std::move(wanted)](const std::stop_token& token) {
    give_way_to_the_window();
    auto result = proved_bake(*frames, wanted, token);
    {
      const std::lock_guard lock(mutex_);
      if (!result || number != number_) return;
      result_ = std::move(result);
    }
    if (wake_) wake_();
  });
}

void BackgroundBake::cancel() {
  {
    const std::lock_guard lock(mutex_);
    ++number_;
    result_ = nullptr;
  }
  job_.cancel();
}

std::shared_ptr<const BakeResult> BackgroundBake::result() const {
  const std::lock_guard lock(mutex_);
  return result_;
}

}  // namespace foldless
