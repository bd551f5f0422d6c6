// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_bake.h"

#include <exception>
#include <utility>

#include "core/exception_words.h"
#include "core/run/thread_priority.h"

namespace foldless {
namespace {

/// False when the token was set.
bool bake_and_prove(const Frames& frames, const SolvedToBake& wanted, const std::stop_token& token,
                    BakeResult& result) {
  try {
    auto baked = bake_solved(frames, wanted, token);
    if (!baked) return false;
    result.baked = std::move(*baked);
    const std::vector<BakedFailure> failures = failures_of(result.baked);
    if (!failures.empty()) result.failure = failures.front();
  } catch (const std::exception& failure) {
    result.error = words_of_exception(failure);
  }
  return true;
}

}  // namespace

void BackgroundBake::start(std::shared_ptr<const Frames> frames, SolvedToBake wanted) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = ++number_;
    result_ = nullptr;
  }
  job_.start([this, number, frames = std::move(frames), wanted = std::move(wanted),
              result = std::make_shared<BakeResult>()](const std::stop_token& token) {
    give_way_to_the_window();
    if (!bake_and_prove(*frames, wanted, token, *result)) return;
    {
      const std::lock_guard lock(mutex_);
      if (number != number_) return;
      result_ = result;
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
