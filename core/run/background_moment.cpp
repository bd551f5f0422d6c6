// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run/background_moment.h"

#include <exception>
#include <utility>

namespace foldless {

std::shared_ptr<const SolvedFrame> BackgroundMoment::at(
    double moment, const std::shared_ptr<const SolvedFrame>& before,
    const std::shared_ptr<const Frames>& frames) {
  if (moment == moment_ && before == before_) {
    const std::lock_guard lock(mutex_);
    return solved_;
  }
  moment_ = moment;
  before_ = before;
  {
    const std::lock_guard lock(mutex_);
    solved_ = nullptr;
  }
  job_.start([this, moment, before, frames](const std::stop_token& token) {
    try {
      auto solved = frames->solve(moment, before->snapshot.get(), token);
      if (!solved) return;
      auto moved = std::make_shared<const SolvedFrame>(std::move(*solved));
      const std::lock_guard lock(mutex_);
      if (token.stop_requested()) return;
      solved_ = std::move(moved);
    } catch (const std::exception&) {
      return;  // The frames beside it say what is wrong with the animation.
    }
    if (wake_) wake_();
  });
  return nullptr;
}

}  // namespace foldless
