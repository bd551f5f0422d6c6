// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "app/editor/key_edits.h"
#include "app/gui/easing_curve.h"
#include "app/gui/time_line_place.h"

namespace foldless {

class Editor;
struct PanelContext;

/// The pointer's gesture on the time line.
struct TimeLineGesture {
  enum class Kind {
    none,
    scrub,    ///< the play head follows
    keys,     ///< moves the selected keys; with Ctrl held at the end copies them
    stretch,  ///< of the selected keys, about the one furthest from that which is pulled
    band      ///< selects what is inside
  };
  Kind kind = Kind::none;
  ImVec2 start{0, 0};     ///< pixels of the window
  int grabbed_frame = 0;  ///< where what is pulled was
  int low = 0, high = 0;  ///< the first and the last frame of the selected keys
  Keys before = {};       ///< selected when a band began that adds
  Keys selected = {};     ///< when a band began
};

/// What the time line remembers from frame to frame.
struct TimeLineState {
  TimeLineGesture gesture = {};
  TimeLineView view = {};
  std::optional<PulledCurve> pulled_curve = {};  ///< of an easing
  double seen_moment = 0;                        ///< of the play head, which was brought into sight
};

/// `Both` and so on.
std::string title_of(const NamedEasing& easing);

/// Frames per second, length, loop, easing: what stands beside the transport.
void draw_motion_controls(Editor& editor, const PanelContext& context);
/// Ruler, play head and keys: `state.time_line` of the context.
void draw_time_line(Editor& editor, const PanelContext& context);

}  // namespace foldless
