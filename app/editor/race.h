// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/editor/canvas.h"
#include "app/editor/race_lane.h"
#include "app/editor/status.h"

namespace foldless {

/// The same handles on the same mesh under two to four methods or parameter values, side by side.
/// All lanes are shown after the same number of iterations, the tick; a lane that has ended stays
/// at its end. Each lane solves on a thread of its own; the tick follows the slowest that is
/// still running, at the pace that was asked for. One thread only.
class Race {
 public:
  explicit Race(std::function<void()> wake);

  bool is_open() const { return document_.has_value(); }
  /// Begins a race of methods on a document that has handles.
  void open(Document document);
  void close();
  /// The document that the race is about. Precondition: is_open().
  const Document& document() const { return *document_; }

  const RaceSetup& setup() const { return setup_; }
  /// Begins anew, with other lanes or another start.
  void set_setup(RaceSetup setup);
  void restart();

  const std::vector<std::unique_ptr<RaceLane>>& lanes() const { return lanes_; }

  /// Takes what the lanes have done and moves the tick. Returns whether anything changed.
  bool update(double now);
  /// When update() must be called again though nothing happens, if ever. [s]
  std::optional<double> next_wake() const;

  std::size_t tick() const { return tick_; }
  /// The furthest tick that was shown: how far curves go.
  std::size_t furthest() const { return furthest_; }
  /// Every lane has ended, and its end is shown.
  bool is_finished() const;
  bool is_playing() const { return is_playing_ && !is_finished(); }
  /// The race as a whole, in words.
  Status status() const;
  /// Pauses all lanes, or goes on.
  void toggle();
  /// The next tick, then pause; where no lane has gone on before, one iteration of each.
  void step_forward();
  void step_back();
  void first_tick() { scrub(0); }
  void last_tick() { scrub(furthest_); }
  /// Shows an earlier tick, or one up to furthest(); pauses.
  void scrub(std::size_t tick);
  /// Ticks a second; nothing: as fast as the lanes go.
  void set_pace(std::optional<double> pace) { pace_ = pace; }

  // The view, which all lanes share.

  const Canvas& canvas() const { return canvas_; }
  /// Size of a lane in framebuffer pixels.
  void resize(int width, int height, double ui_scale);
  void set_camera(const Camera& camera) {
    canvas_.camera = camera;
    is_fitted_ = false;
  }
  /// Shows what is on the lanes, and the targets.
  void fit();

 private:
  /// The tick that every lane has reached or will never reach.
  std::size_t reached() const;
  void pause();

  std::function<void()> wake_;
  std::optional<Document> document_;
  RaceSetup setup_;
  std::vector<std::unique_ptr<RaceLane>> lanes_;
  std::size_t tick_ = 0;
  std::size_t furthest_ = 0;
  std::size_t wanted_ = 0;  ///< tick that step_forward() asked for
  bool is_playing_ = false;
  std::optional<double> pace_;
  double next_tick_ = 0;  ///< not before this time [s]
  Canvas canvas_;
  bool needs_fit_ = true;
  bool is_fitted_ = false;  ///< nobody has moved the view since fit()
};

}  // namespace foldless
