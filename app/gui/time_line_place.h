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

/// Where frames and rows are in the window. Below the ruler the first row has the keys of all.
struct TimeLinePlace {
  Rectangle area;     ///< of the ruler and the rows
  float labels = 0;   ///< how wide the names of rows are
  float margin = 0;   ///< beside the first and the last frame
  float ruler = 0;    ///< its height
  float row = 0;      ///< the height of one
  int last = 1;       ///< the largest frame, > 0
  int first_row = 0;  ///< of time_line_rows() that is in sight

  float left() const { return area.x + labels + margin; }
  float width() const { return area.width - labels - 2 * margin; }
  float x_of(double frame) const {
    return left() + width() * static_cast<float>(frame) / static_cast<float>(last);
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
                              int first_row);

}  // namespace foldless
