// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/edge_lines.h"

#include "render/theme.h"

namespace foldless {
namespace {

constexpr float kWireFade = 9;  // design pixels; edges of a mesh finer than this grow fainter

float edge_width(float width, const ViewOptions& options) {
  return width * static_cast<float>(options.line_width);
}

}  // namespace

std::vector<EdgeLines> edge_lines(const ViewOptions& options) {
  const CanvasColours& colours = canvas_colours(options.theme);
  const bool is_filled = options.layers.fill || options.layers.heat;
  std::vector<EdgeLines> lines;
  if (options.layers.wireframe) {
    // Without a fill the edges lie on the canvas and take the colour that stands out there.
    const glm::vec4& colour = is_filled ? colours.wire : colours.rest;
    lines.push_back({EdgeSet::interior,
                     {.colour = colour, .width = edge_width(1, options), .fade_below = kWireFade}});
  }
  const auto add_round = [&](EdgeSet set, const glm::vec4& colour, float width) {
    lines.push_back(
        {set, {.colour = colour, .width = edge_width(width, options), .has_round_ends = true}});
  };
  if (options.layers.boundary)
    add_round(EdgeSet::boundary, is_filled ? colours.boundary : colours.text, 2);
  if (options.layers.remeshed) {
    add_round(EdgeSet::flipped, colours.casing, 4.5F);
    add_round(EdgeSet::flipped, colours.flipped, 2.25F);
  }
  return lines;
}

LineStyle rest_outline(const ViewOptions& options) {
  return {.colour = canvas_colours(options.theme).rest,
          .width = edge_width(1.5F, options),
          .has_round_ends = true};
}

}  // namespace foldless
