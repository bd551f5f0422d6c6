// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec4.hpp>

#include "render/view_options.h"

namespace foldless {

/// Colours of the canvas, sRGB with straight alpha.
struct CanvasColours {
  glm::vec4 background;
  glm::vec4 checker_light;
  glm::vec4 checker_dark;
  glm::vec4 wire;
  glm::vec4 boundary;
  glm::vec4 rest;        ///< outline of the rest mesh
  glm::vec4 handle;      ///< inside of a handle
  glm::vec4 handle_rim;  ///< its outline, which sets it off from any fill
  glm::vec4 selected;    ///< inside of a selected handle
  glm::vec4 hovered;     ///< halo of the handle under the mouse
  glm::vec4 target;      ///< ghost ring and the line to it
  glm::vec4 flipped;     ///< flipped edges
  glm::vec4 casing;      ///< beside flipped edges, which would drown in a fill
  glm::vec4 folded;      ///< triangles that are turned over, where a method allows them
  glm::vec4 split;       ///< vertices made by splits
  glm::vec4 text;        ///< numbers of the legend
};

const CanvasColours& canvas_colours(Theme theme);

}  // namespace foldless
