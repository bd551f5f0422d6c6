// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/editor/key_edits.h"
#include "app/gui/layout.h"

namespace foldless {

/// A row of the time line: the keys of one property of one handle.
struct TimeLineRow {
  int handle = 0;
  KeyedProperty property = KeyedProperty::position;
};
std::vector<TimeLineRow> time_line_rows(const Animation& animation);

/// What part of the time line is in sight.
struct TimeLineView {
  int first_row = 0;  ///< of time_line_rows()
  double first = 0;   ///< the moment at the left end [frames]
  double zoom = 1;    ///< ≥ 1: all frames take so many times the room that there is
};

/// Where frames and rows are in the window. Below the ruler the first row has the keys of all.
struct TimeLinePlace {
  Rectangle area;     ///< of the ruler and the rows
  float labels = 0;   ///< how wide the names of rows are
  float margin = 0;   ///< beside the first and the last frame
  float ruler = 0;    ///< its height
  float row = 0;      ///< the height of one
  int last = 1;       ///< the largest frame, > 0
  int first_row = 0;  ///< of time_line_rows() that is in sight
  double first = 0;   ///< the moment at the left end [frames]
  double shown = 1;   ///< so many frames are in sight, > 0

  float left() const { return area.x + labels + margin; }
  float width() const { return area.width - labels - 2 * margin; }
  float x_of(double frame) const {
    return left() + width() * static_cast<float>((frame - first) / shown);
  }
  bool is_in_sight(double frame) const {
    return first - 1e-9 <= frame && frame <= first + shown + 1e-9;
  }
  /// Any moment, kept within the cycle. [frames]
  double moment_at(float x) const;
  /// The nearest frame.
  int frame_at(float x) const;
  float y_of_all() const { return area.y + ruler + row / 2; }
  /// The middle of a row of time_line_rows(); may be out of sight.
  float y_of(int index) const {
    return y_of_all() + row * static_cast<float>(index - first_row + 1);
  }
  /// −1: the row of all keys.
  int row_at(float y) const;
  int rows_in_sight() const;
};

/// `timeline` as in Layout, with the rows of the transport above.
TimeLinePlace time_line_place(const Rectangle& timeline, float scale, const Cycle& cycle,
                              const TimeLineView& view);

/// The view with a zoom by `factor` about a moment, which stays where it is; no closer than a few
/// frames.
TimeLineView zoomed(const TimeLineView& view, double factor, double about, const Cycle& cycle);
/// The view moved by so many frames, kept within the cycle.
TimeLineView scrolled(const TimeLineView& view, double by, const Cycle& cycle);
/// The view moved just so far that a moment is in sight.
TimeLineView with_moment_in_sight(const TimeLineView& view, double moment, const Cycle& cycle);

}  // namespace foldless
