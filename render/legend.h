// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/distortion.h"
#include "render/image.h"
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

/// Draws the bar of colours with its numbers at the right border of a picture, in the middle.
void draw_legend(Image& image, const HeatRange& range, const ViewOptions& style);

}  // namespace foldless
