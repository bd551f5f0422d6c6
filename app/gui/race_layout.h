// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "app/gui/layout.h"

namespace foldless {

/// Where the parts of a race are, in framebuffer pixels.
struct RaceLayout {
  struct Lane {
    Rectangle head;  ///< what it is and how it stands
    Rectangle view;  ///< its mesh
  };
  Rectangle setup;
  std::vector<Lane> lanes;  ///< from left to right, views of one size
  Rectangle results;        ///< plots and table
};

/// Fills the area but for lines between the lanes. `scale`: framebuffer pixels in a design pixel.
RaceLayout race_layout_for(const Rectangle& area, std::size_t lanes, float scale);

}  // namespace foldless
