// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/editor/draft.h"
#include "app/editor/messages.h"

namespace foldless {

/// The document's animation; one without keys where it has none.
const Animation& animation_in(const Document& document);

/// Which moment of its animation a draft is looked at: a frame, or between two.
class PlayHead {
 public:
  /// Keeps references.
  PlayHead(Draft& draft, Messages& messages) : draft_(draft), messages_(messages) {}

  /// The nearest frame, where keys are set.
  int frame() const { return frame_; }
  /// Where it stands, in frames from the start.
  double moment() const { return between_.value_or(frame_); }
  bool is_between() const { return between_.has_value(); }
  int last_frame() const { return animation().cycle.frames - 1; }

  void go_to(int frame);  ///< kept within the cycle
  /// Anywhere in the cycle: that moment is solved from the frame before it.
  void go_between(double moment);
  void go_to_nearest_frame() { between_.reset(); }
  void step_forward();  ///< from the last to the first
  void step_back();
  void first() { go_to(0); }
  void last() { go_to(last_frame()); }

  std::optional<int> key_after() const;   ///< the nearest frame with a key after frame()
  std::optional<int> key_before() const;  ///< likewise before it
  void next_key();
  void previous_key();

  void toggle_play();
  bool is_playing() const { return play_.has_value(); }
  void stop() { play_.reset(); }
  /// Back into the cycle, whose length may have changed.
  void stay_in_cycle();
  /// While it plays, to where it is due.
  void advance();
  /// When advance() has something to do, if ever. [s]
  std::optional<double> next_wake() const;

 private:
  struct Playing {
    double since = 0;  ///< by the editor's clock [s]
    int from = 0;
  };

  const Animation& animation() const { return animation_in(draft_.document()); }
  int end() const { return animation().cycle.loops ? last_frame() + 1 : last_frame(); }

  Draft& draft_;
  Messages& messages_;
  int frame_ = 0;
  std::optional<double> between_;  ///< absent: it stands at the frame
  std::optional<Playing> play_;
};

/// `7`, or `7.25` between frames.
std::string moment_words(double moment);

}  // namespace foldless
