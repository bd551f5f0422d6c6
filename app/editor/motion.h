// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/draft.h"
#include "app/editor/messages.h"
#include "app/editor/motion_bake.h"
#include "app/editor/motion_frames.h"
#include "app/editor/motion_keys.h"
#include "app/editor/play_head.h"

namespace foldless {

/// The time line of a draft: its play head, and the keys of its handles. While it is open the mesh
/// on screen is the frame at the play head, and an edit of a handle there sets a key where the
/// handle has keys, or where it records.
class Motion {
 public:
  /// Keeps references. `wake` is called on another thread when update() has news.
  Motion(Draft& draft, Messages& messages, std::function<void()> wake);

  bool is_open() const { return is_open_; }
  void toggle();
  const Animation& animation() const { return animation_in(draft_.document()); }
  bool has_keys() const { return !animation().tracks.empty(); }

  PlayHead& play_head() { return play_head_; }
  const PlayHead& play_head() const { return play_head_; }
  MotionKeys& keys() { return keys_; }
  const MotionKeys& keys() const { return keys_; }

  bool has_onion_skin() const { return has_onion_skin_; }
  void toggle_onion_skin();
  /// The frames of the keys before and after the play head, as far as they are solved.
  std::vector<std::shared_ptr<const Snapshot>> neighbours() const;

  const MotionFrames& frames() const { return frames_; }
  /// What is solved of the moment at the play head; null while nothing is.
  std::shared_ptr<const SolvedFrame> solved() const;
  /// How far a loop that does not close is from its first shape [pixels of a picture with 1024
  /// along the longer side]; nothing of one that closes, and while it is not known.
  std::optional<double> gap() const;
  MotionProofStatus proof() const { return bake_.status(); }
  const MotionBake& bake() const { return bake_; }
  void update();
  /// When update() has something to do, if ever. [s]
  std::optional<double> next_wake() const;

 private:
  void show();

  Draft& draft_;
  Messages& messages_;
  PlayHead play_head_;
  MotionKeys keys_;
  MotionFrames frames_;
  MotionBake bake_;
  MotionProofStatus::State proof_ = MotionProofStatus::State::none;  ///< that is on screen
  bool is_open_ = false;
  bool has_onion_skin_ = false;
  std::shared_ptr<const SolvedFrame> solved_between_;  ///< null: not solved, or at a frame
  std::shared_ptr<const SolvedFrame> shown_;           ///< that is on screen
  std::shared_ptr<const Animation> of_;                ///< the animation that it was shown for
  std::shared_ptr<const Shape> original_;              ///< of the document that was seen last
};

}  // namespace foldless
