// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/method/stepped_method.h"

namespace foldless {

void SteppedMethod::begin(Steps<Outcome> steps) {
  outcome_.reset();
  steps_.emplace(std::move(steps));
  steps_->begin(context_);
  see_whether_ended();
}

std::optional<Iteration> SteppedMethod::step(const std::stop_token& token) {
  if (!steps_ || outcome_ || token.stop_requested()) return std::nullopt;
  const double start = thread_seconds();
  const StageTimer wall(wall_seconds_);
  context_.record.reset();
  // A relaxation that has nothing to do is a request without a record; so are a coarse mesh and its
  // map, after which the first update of a large mesh is far.
  while (!outcome_ && !context_.record && !token.stop_requested() &&
         context_.request->make(token)) {
    context_.waiting.resume();
    see_whether_ended();
  }
  seconds_ += thread_seconds() - start;
  if (context_.record) context_.record->seconds = seconds_;
  return context_.record;
}

StageTimes SteppedMethod::times() const {
  return wall_seconds_ > 0 ? seconds_ / wall_seconds_ * stage_times() : StageTimes();
}

void SteppedMethod::see_whether_ended() {
  if (!steps_->have_ended()) return;
  Steps<Outcome> ended = *std::move(steps_);
  steps_.reset();
  outcome_ = ended.result();
}

}  // namespace foldless
