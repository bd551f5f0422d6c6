// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <optional>
#include <span>
#include <string>

#include "app/gui/theme.h"

namespace foldless {

/// A curve over the iterations: values[i] belongs to iteration i.
struct Plot {
  const char* id = "";     ///< unique in its window
  const char* title = "";  ///< drawn above the curve
  std::span<const double> values;
  ImVec4 colour;
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

/// Draws a curve with a logarithmic axis and its last value in numbers. Returns the iteration
/// under the mouse while the button is held on the plot: the caller's timeline goes there.
std::optional<std::size_t> draw_log_plot(const Plot& plot, const Palette& palette);

}  // namespace foldless
