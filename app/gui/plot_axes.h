// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/gui/plot.h"

namespace foldless {

/// A number written beside the axis.
struct PlotTick {
  double value = 0;
  std::string label;
};

/// The rectangle of the curves, and what its borders mean.
struct PlotAxes {
  ImVec2 min, max;        ///< framebuffer pixels, y down
  double low = 0;         ///< value at the bottom, an exponent of ten on a logarithmic axis
  double high = 1;        ///< and at the top
  std::size_t count = 0;  ///< values of the longest curve
  bool is_logarithmic = true;
  bool has_zero = false;  ///< a logarithmic axis whose bottom stands for 0

  bool has_whole_positions = true;  ///< iterations, not seconds
  double first = 1;                 ///< position at the left border
  double last = 2;                  ///< and at the right

  float x(double position) const;
  float y(double value) const;
  /// False for what the axis cannot show.
  bool is_drawable(double value) const;
  bool is_in_sight(double position) const { return position >= first && position <= last; }
  /// Within the borders.
  double position_at(float x) const;
  /// Powers of ten, or round numbers, at least `distance` pixels apart where possible.
  std::vector<PlotTick> ticks(float distance) const;
  /// Round positions at least `distance` pixels apart where possible.
  std::vector<PlotTick> position_ticks(float distance) const;
};

/// The value of the longest curve whose position is nearest. Precondition: one has values.
std::size_t index_near(const Plot& plot, double position);

/// Axes that hold every curve of a plot whose upper left corner is `corner`.
PlotAxes axes_of(const Plot& plot, const ImVec2& corner);

}  // namespace foldless
