// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <string_view>
#include <vector>

#include "render/image.h"

namespace foldless {

/// Where and how a line of text is drawn; lengths in pixels.
struct StrokeText {
  glm::dvec2 baseline{0, 0};     ///< left end of the base line, y from the top
  double height = 10;            ///< of a digit
  glm::vec4 colour{0, 0, 0, 1};  ///< straight alpha
};

/// A stroke with round ends, in pixels.
struct StrokeLine {
  glm::dvec2 a, b;
};

/// The strokes of a text; see draw_stroke_text().
std::vector<StrokeLine> stroke_lines(std::string_view text, const StrokeText& place);
/// How wide the strokes of a text are. [pixels]
double stroke_width(double height);

/// Draws text in single strokes, for numbers in pictures without a font: the digits, `.-+e/A'`
/// and σ, written as `s`. Other characters leave a gap.
void draw_stroke_text(Image& image, std::string_view text, const StrokeText& place);

/// Pixels from the first stroke to the last.
double stroke_text_width(std::string_view text, double height);

}  // namespace foldless
