// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/run/frames.h"

namespace foldless {

/// What pictures of an animation show, whichever frame they are of. [length]
struct FramesBox {
  Vec2 min, max;

  double width() const { return max.x() - min.x(); }
  double height() const { return max.y() - min.y(); }
};

/// Width and height. [pixels]
using PictureSize = std::array<int, 2>;

/// The box round the shapes of all frames, with a margin.
FramesBox box_round(const std::vector<SolvedFrame>& frames);

/// 1024 pixels along the longer side; even numbers, as codecs of films take them.
PictureSize size_for(const FramesBox& box);

/// Of a picture that shows the whole box; without a size of that of size_for(). [length]
double length_of_a_pixel(const FramesBox& box, const std::optional<PictureSize>& size);

}  // namespace foldless
