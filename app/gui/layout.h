// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/extent.h"

namespace foldless {

/// A rectangle in framebuffer pixels, y down.
struct Rectangle {
  float x = 0, y = 0, width = 0, height = 0;

  bool contains(double px, double py) const {
    return px >= x && py >= y && px < x + width && py < y + height;
  }
};

/// Where the parts of the window are. They never overlap and fill the window, but for
/// the line between two panes.
struct Layout {
  Rectangle menu_bar;
  Rectangle left;   ///< layers, handles, history; without width in a narrow window
  Rectangle right;  ///< solver, plots, iterations; and what was left in a narrow window
  Rectangle canvas;
  Rectangle
      rest;  ///< the pane beside the canvas, as large as it; without width where there is none
  Rectangle timeline;
  Rectangle status_bar;
  bool is_narrow = false;  ///< all sections share the right panel
};

/// For a framebuffer and framebuffer pixels in one design pixel. `shows_panels` false leaves the
/// whole width to the canvas.
Layout layout_for(Extent framebuffer, float scale, bool shows_panels);

/// Gives the left half of the canvas to the pane of the rest mesh.
void split_canvas(Layout& layout, float scale);

}  // namespace foldless
