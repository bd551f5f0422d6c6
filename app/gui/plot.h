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
  /// Where each value stands along the axis, never falling; empty: 1, 2, 3 …
  std::vector<double> positions = {};

  double position(std::size_t index) const {
    return positions.empty() ? static_cast<double>(index) + 1 : positions[index];
  }
};

/// The part of the horizontal axis that is seen, in fractions of its length.
struct PlotZoom {
  double first = 0, last = 1;

  bool is_whole() const { return first <= 0 && last >= 1; }
};

/// Shows `factor` times as much, with what is at `place` (a fraction of what is seen) staying
/// there.
PlotZoom zoomed(const PlotZoom& zoom, double place, double factor);

/// Curves over one axis.
struct Plot {
  const char* id = "";     ///< unique in its window
  const char* title = "";  ///< drawn above the curves
  std::span<const PlotCurve> curves;
  bool is_logarithmic = true;
  std::optional<std::size_t> cursor;  ///< iteration to mark
  ImVec2 size;                        ///< framebuffer pixels
  ImFont* font = nullptr;             ///< for numbers
  PlotZoom* zoom = nullptr;           ///< changed by Ctrl and the wheel; null: all is seen
  const char* unit = "";              ///< of positions, behind the last number of the axis
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
/// mouse while the button is held on the plot: the caller's timeline goes there. Ctrl and the wheel
/// zoom along the axis, a double click shows all of it.
std::optional<std::size_t> draw_plot(const Plot& plot, const Palette& palette);

/// A line of that look, to tell which curve is whose.
void draw_line_sample(const PlotCurve& curve, const ImVec2& from, const ImVec2& to,
                      float thickness);

}  // namespace foldless
