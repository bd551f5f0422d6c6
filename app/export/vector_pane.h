// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "app/export/cairo.h"
#include "app/export/polygon_clip.h"
#include "render/camera.h"
#include "render/line_style.h"

namespace foldless {

/// A rectangle of a figure that is drawn into; the origin is its upper left corner, in pixels.
struct VectorPane {
  cairo_t* cairo;
  glm::dvec2 size;
  double ui_scale = 1;  ///< pixels in one design pixel
};

/// What a pane may show of things that reach out of it.
Box seen_box(const VectorPane& pane);

void set_colour(const VectorPane& pane, const glm::vec4& colour);

/// Adds a polygon to the path, turned clockwise on screen, so that overlapping ones fill as one.
/// What is out of sight is left out, and what reaches far is cut, since cairo's numbers are small.
void add_polygon(const VectorPane& pane, Polygon polygon);

/// Adds a line to the path, or nothing where it is out of sight.
void add_line(const VectorPane& pane, glm::dvec2 a, glm::dvec2 b);

/// Sets colour, width, ends and dashes, the opacity times `share`.
void set_line(const VectorPane& pane, const LineStyle& style, double share = 1);

}  // namespace foldless
