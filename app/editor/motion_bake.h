// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/editor/document.h"
#include "app/editor/motion_frames.h"
#include "core/run/background_bake.h"

namespace foldless {

/// What is known of the moments between the frames of an animation.
struct MotionProofStatus {
  enum class State {
    none,     ///< not all frames are solved
    running,  ///< they are being baked
    proved,   ///< every moment of the baked animation is injective
    unproved  ///< one is not, or it could not be made
  };
  State state = State::none;
  std::size_t frames = 0;
  Eigen::Index vertices = 0;  ///< of the baked mesh
  double deviation = 0;       ///< [pixels] of a picture of the usual size
  std::string problem;        ///< `triangle 12 has no area at frame 3.5`
};

/// Bakes the frames of a document in the background whenever all of them are solved, and so proves
/// all moments between them.
class MotionBake {
 public:
  explicit MotionBake(std::function<void()> wake) : bake_(std::move(wake)) {}

  /// `rests`: nobody is changing anything. Otherwise what is not done yet is dropped.
  void update(const Document& document, const MotionFrames& frames, bool rests);
  MotionProofStatus status() const;
  /// Null while there is none.
  std::shared_ptr<const BakeResult> result() const { return bake_.result(); }

 private:
  void drop();

  BackgroundBake bake_;
  std::shared_ptr<const SolvedFrame> of_;  ///< the last of the frames that are baked; null: none
  std::size_t count_ = 0;
  double pixel_ = 0;  ///< [length]
};

}  // namespace foldless
