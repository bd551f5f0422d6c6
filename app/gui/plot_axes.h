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
  std::size_t count = 0;  ///< iterations
  bool is_logarithmic = true;
  bool has_zero = false;  ///< a logarithmic axis whose bottom stands for 0

  float x(std::size_t index) const;
  float y(double value) const;
  /// False for what the axis cannot show.
  bool is_drawable(double value) const;
  /// The iteration at a pixel. Precondition: count > 0.
  std::size_t index_at(float x) const;
  /// Powers of ten, or round numbers, at least `distance` pixels apart where possible.
  std::vector<PlotTick> ticks(float distance) const;
};

/// Axes that hold every curve of a plot whose upper left corner is `corner`.
PlotAxes axes_of(const Plot& plot, const ImVec2& corner);

}  // namespace foldless
