// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/editor/draft.h"
#include "app/editor/messages.h"
#include "app/editor/race.h"

namespace foldless {

/// The solver of a draft as a player: pause, pace, and its iterations to go back to.
class Playback {
 public:
  /// Keeps references. A race has the same pace.
  Playback(Draft& draft, Race& race, Messages& messages)
      : draft_(draft), race_(race), messages_(messages) {}

  SolvingState state() const { return draft_.solving().state(); }
  bool is_solving() const { return draft_.solving().is_running(); }
  void toggle_pause();
  void stop();
  /// Iterations a second, 1 … 60; nothing: as fast as it goes.
  void set_pace(std::optional<double> pace);
  std::optional<double> pace() const { return pace_; }

  /// Every iteration since the last edit, in order.
  const std::vector<Iteration>& iterations() const { return draft_.solving().iterations(); }
  /// True when the solver rests and there is an iteration to go to.
  bool can_scrub() const;
  /// The iteration that is shown, when it is not the newest state.
  std::optional<std::size_t> scrubbed() const;
  void scrub(std::size_t index);
  void step_forward();  ///< the next iteration; at the end one of the solver
  void step_back();     ///< the iteration before; pauses first when solving
  void first();
  void last();
  /// Makes what is shown the newest state: of an iteration an undo step.
  void use_iteration();

  /// Plays the iterations from the one that is shown, from the first at the end; or stops. At the
  /// pace, or kFullSpeed a second.
  void toggle_play();
  bool is_playing() const { return next_.has_value(); }
  void toggle_loop() { loops_ = !loops_; }
  bool loops() const { return loops_; }
  /// Goes on when it is time; ends when the solver goes on or an edit begins.
  void update();
  /// When update() has something to do, if ever. [s]
  std::optional<double> next_wake() const { return next_; }

  static constexpr double kFullSpeed = 24;  ///< iterations a second

 private:
  void show(std::size_t index);

  Draft& draft_;
  Race& race_;
  Messages& messages_;
  std::optional<double> pace_;
  std::optional<double> next_;  ///< when the next iteration is shown; nothing: it does not play [s]
  bool loops_ = false;
};

}  // namespace foldless
