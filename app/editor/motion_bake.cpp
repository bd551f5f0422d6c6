// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/motion_bake.h"

#include "core/run/frames_box.h"
#include "core/scene/failure_words.h"

namespace foldless {
namespace {

constexpr double kTolerance = 0.5;  ///< [pixels]

}  // namespace

void MotionBake::drop() {
  if (!of_) return;
  bake_.cancel();
  of_ = nullptr;
}

/// Frames that were solved anew are others by their address.
void MotionBake::update(const Document& document, const MotionFrames& frames, bool rests) {
  if (!rests) {
    if (!bake_.result()) drop();
    return;
  }
  const FramesStatus status = frames.status();
  const auto last = status.is_done ? frames.frame(static_cast<int>(status.count) - 1) : nullptr;
  if (!last) return drop();
  if (last == of_) return;
  of_ = last;
  count_ = status.count;
  SolvedToBake wanted{document.original->triangles, frames.solved(),
                      document.animation->cycle.loops, 0};
  pixel_ = length_of_a_pixel(box_round(wanted.solved), std::nullopt);
  wanted.tolerance = kTolerance * pixel_;
  bake_.start(frames.solver(), std::move(wanted));
}

MotionProofStatus MotionBake::status() const {
  MotionProofStatus status;
  if (!of_) return status;
  status.frames = count_;
  const auto result = bake_.result();
  if (!result) {
    status.state = MotionProofStatus::State::running;
    return status;
  }
  const bool is_proved = result->error.empty() && !result->failure;
  status.state = is_proved ? MotionProofStatus::State::proved : MotionProofStatus::State::unproved;
  status.vertices = result->baked.rest.cols();
  status.deviation = result->baked.deviation / pixel_;
  status.problem = result->error;
  if (result->failure) status.problem = words_of(*result->failure, result->baked);
  return status;
}

}  // namespace foldless
