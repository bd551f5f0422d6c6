// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/editor/draft.h"
#include "app/editor/key_edits.h"
#include "app/editor/messages.h"
#include "app/editor/motion_bake.h"
#include "app/editor/motion_frames.h"

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
  /// The document's animation; one without keys where it has none.
  const Animation& animation() const;
  bool has_keys() const { return !animation().tracks.empty(); }

  // The play head stands at a frame, or between two.

  /// The nearest frame, where keys are set.
  int frame() const { return frame_; }
  /// Where it stands, in frames from the start.
  double moment() const { return between_.value_or(frame_); }
  int last_frame() const { return animation().cycle.frames - 1; }
  void go_to(int frame);  ///< kept within the cycle
  /// Anywhere in the cycle: that moment is solved from the frame before it.
  void go_between(double moment);
  void step_forward();  ///< from the last to the first
  void step_back();
  void first() { go_to(0); }
  void last() { go_to(last_frame()); }
  void next_key();
  void previous_key();
  void toggle_play();
  bool is_playing() const { return play_.has_value(); }
  void stop() { play_.reset(); }

  // Keys. Every change is one undo step.

  /// Whether an edit of a handle without keys sets one, and one at frame 0 with what was before.
  bool records() const { return records_; }
  void toggle_records();
  /// Keys at the play head of the selected handles, or of all where none is: for position and
  /// angle, and for depth and weight where these have keys already.
  void key_handles();
  /// A key at the play head for one property of one handle.
  void key_row(int handle, KeyedProperty property);
  /// Ids and frames that the animation has; the rest is passed over.
  const Keys& selected() const { return selected_; }
  void select(const Keys& keys);
  void select_none() { select({}); }
  void delete_selected();
  void move_selected(const std::function<int(int)>& to, bool copies);
  void copy();
  bool can_paste() const { return !copied_.animation.tracks.empty(); }
  void paste();  ///< the first of what was copied at the play head
  void set_easing(const Easing& easing);
  void set_cycle(const Cycle& cycle);
  void set_fps(double fps);
  /// Whether the selected handles go on curves.
  bool is_smooth() const;
  void toggle_smooth();
  /// The selected handles swing about the one that was selected last, or do so no more.
  bool swings() const;
  void toggle_swing();

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
  struct Copied {
    Animation animation;
    int first = 0;
  };
  struct Playing {
    double since = 0;  ///< by the editor's clock [s]
    int from = 0;
  };

  void change(const std::string& label, const std::function<void(Animation&)>& change);
  void key(const std::function<bool(int, KeyedProperty)>& is_due);
  void key_what_changed(const Document& before, Document& after);
  int end() const { return animation().cycle.loops ? last_frame() + 1 : last_frame(); }
  void advance();
  void show();
  std::optional<int> key_after(int frame) const;
  std::optional<int> key_before(int frame) const;

  Draft& draft_;
  Messages& messages_;
  MotionFrames frames_;
  MotionBake bake_;
  MotionProofStatus::State proof_ = MotionProofStatus::State::none;  ///< that is on screen
  bool is_open_ = false;
  bool records_ = true;
  bool has_onion_skin_ = false;
  int frame_ = 0;
  std::optional<double> between_;  ///< absent: the play head stands at the frame
  std::shared_ptr<const SolvedFrame> solved_between_;  ///< there; null while it is not
  std::optional<Playing> play_;
  Keys selected_;
  Copied copied_;
  std::shared_ptr<const SolvedFrame> shown_;  ///< that is on screen
  std::shared_ptr<const Animation> of_;       ///< the animation that it was shown for
  std::shared_ptr<const Shape> original_;     ///< of the document that was seen last
};

/// `7`, or `7.25` between frames.
std::string moment_words(double moment);

}  // namespace foldless
