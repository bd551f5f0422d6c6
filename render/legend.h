// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render/distortion.h"
#include "render/image.h"
#include "render/stroke_font.h"
#include "render/view_options.h"

namespace foldless {

/// A number beside the bar of a legend.
struct LegendTick {
  double t = 0;       ///< place on the scale, in [0, 1]
  std::string label;  ///< the value there, three digits
};

/// Round numbers of the scale (1, 2, 5 times powers of ten) with its ends; `at_most` ≥ 2 of them.
std::vector<LegendTick> legend_ticks(const HeatRange& range, int at_most);

/// Pixels that a legend takes at the right border.
int legend_width(double ui_scale);

/// The rectangle of a legend's colours, in pixels from the top left corner.
struct LegendBar {
  int left, top, width, height;
};

/// Words of a legend and where they are.
struct LegendText {
  std::string words;
  StrokeText place;
};

/// A legend in a picture of a certain size.
struct Legend {
  LegendBar bar{};            ///< viridis from 0 at its lower end, framed in `colour`
  std::vector<double> marks;  ///< heights of the lines at its right side [pixels from the top]
  int mark_length = 0;        ///< pixels
  std::vector<LegendText> texts;
  glm::vec4 colour{0};
};

/// The legend at the right border, in the middle. Nothing where there is no room.
std::optional<Legend> legend_of(int width, int height, const HeatRange& range,
                                const ViewOptions& style);

/// Draws the bar of colours with its numbers at the right border of a picture, in the middle.
void draw_legend(Image& image, const HeatRange& range, const ViewOptions& style);

}  // namespace foldless
