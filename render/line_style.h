// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>

namespace foldless {

/// How lines look; lengths in design pixels, so that they do not depend on zoom.
struct LineStyle {
  glm::vec4 colour{0, 0, 0, 1};  ///< straight alpha
  float width = 1;
  float dash = 0;        ///< length of dashes and gaps; 0: a solid line
  float fade_below = 0;  ///< shorter segments are fainter, so that dense meshes do not go black
  bool has_round_ends = false;
};

}  // namespace foldless
