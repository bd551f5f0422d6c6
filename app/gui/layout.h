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

/// Along the upper and the left border of a pane; without width where there are none.
struct Rulers {
  Rectangle top;  ///< as wide as the pane and the left one together
  Rectangle left;
};

/// Where the parts of the window are. They never overlap and fill the window, but for
/// the line between two panes.
struct Layout {
  Rectangle menu_bar;
  Rectangle strip;  ///< of tools; without width where there are no panels
  Rectangle left;   ///< without width where there is one panel
  Rectangle right;  ///< without width where there is none
  Rectangle canvas;
  Rectangle
      side;       ///< the pane beside the canvas, as large as it; without width where there is none
  Rulers rulers;  ///< of the canvas
  Rulers side_rulers;  ///< of the pane beside it
  Rectangle timeline;
  Rectangle status_bar;
};

/// How many side panels there are where there is room; without any the canvas has the whole width.
enum class SidePanels { none, one, two };

/// How wide the user wants the side panels. [design pixels]
struct PanelWidths {
  double left = 228, right = 284;
  bool operator==(const PanelWidths&) const = default;
};
inline constexpr PanelWidths kNarrowestPanels{200, 260}, kWidestPanels{640, 640};

/// For a framebuffer and framebuffer pixels in one design pixel. Panels get the widths that are
/// wanted as long as the canvas keeps a third of the window.
Layout layout_for(Extent framebuffer, float scale, SidePanels panels,
                  const PanelWidths& wanted = {});

/// How high the user wants the keys of the time line. [design pixels]
inline constexpr double kTimeLineHeight = 168, kLowestTimeLine = 80, kHighestTimeLine = 800;

/// Gives the time line room for keys at the bottom of the canvas, at most half of that; `height` in
/// design pixels.
void add_time_line(Layout& layout, float scale, double height = kTimeLineHeight);

/// What add_time_line() gave the keys; 0 where it was not called. [design pixels]
double time_line_height(const Layout& layout, float scale);

/// Gives the left half of the canvas to the pane beside it.
void split_canvas(Layout& layout, float scale);

/// Gives rulers what they need of the canvas, and of the pane beside it.
void add_rulers(Layout& layout, float scale);

}  // namespace foldless
