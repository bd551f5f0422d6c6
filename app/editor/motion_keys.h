// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/editor/draft.h"
#include "app/editor/key_edits.h"
#include "app/editor/messages.h"
#include "app/editor/play_head.h"

namespace foldless {

/// The keys of a draft's handles, and how they are changed: every change is one undo step.
class MotionKeys {
 public:
  /// Keeps references.
  MotionKeys(Draft& draft, PlayHead& play_head, Messages& messages)
      : draft_(draft), play_head_(play_head), messages_(messages) {}

  /// Whether an edit of a handle without keys sets one, and one at frame 0 with what was before.
  bool records() const { return records_; }
  void toggle_records();
  /// Sets keys where an edit left a handle other than it would be at the play head, which goes to
  /// its nearest frame then.
  void key_what_changed(const Document& before, Document& after);
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

 private:
  struct Copied {
    Animation animation;
    int first = 0;
  };

  const Animation& animation() const { return animation_in(draft_.document()); }
  void change(const std::string& label, const std::function<void(Animation&)>& change);
  void key(const std::function<bool(int, KeyedProperty)>& is_due);

  Draft& draft_;
  PlayHead& play_head_;
  Messages& messages_;
  bool records_ = true;
  Keys selected_;
  Copied copied_;
};

}  // namespace foldless
