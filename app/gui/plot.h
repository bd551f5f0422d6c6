// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/gui/theme.h"

namespace foldless {

/// How a curve is drawn: told apart without colour.
enum class LineStyle { solid, dashed, dotted, dash_dotted };

/// A curve over the iterations: values[i] belongs to iteration i.
struct PlotCurve {
  std::string name;  ///< shown under the mouse where there are several curves
  std::vector<double> values;
  ImVec4 colour;
  LineStyle style = LineStyle::solid;
};

/// Curves over one axis.
struct Plot {
  const char* id = "";     ///< unique in its window
  const char* title = "";  ///< drawn above the curves
  std::span<const PlotCurve> curves;
  bool is_logarithmic = true;
  std::optional<std::size_t> cursor;  ///< iteration to mark
  ImVec2 size;                        ///< framebuffer pixels
  ImFont* font = nullptr;             ///< for numbers
};

/// Smallest and largest exponent of ten that hold every positive finite value; what is not
/// positive does not count. {0, 1} when there is none.
struct DecadeRange {
  int low = 0;
  int high = 1;
};
DecadeRange decades_of(std::span<const double> values);

/// 10 with a raised exponent, `10⁻⁸`.
std::string power_of_ten(int exponent);

/// Draws the curves, and the last value of a single one in numbers. Returns the iteration under the
/// mouse while the button is held on the plot: the caller's timeline goes there.
std::optional<std::size_t> draw_plot(const Plot& plot, const Palette& palette);

/// A line of that look, to tell which curve is whose.
void draw_line_sample(const PlotCurve& curve, const ImVec2& from, const ImVec2& to,
                      float thickness);

}  // namespace foldless
