// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace foldless {

/// A curve of a plot.
struct Series {
  std::string name;       ///< in the legend; empty: not listed there
  std::vector<double> y;  ///< what is not finite, or not positive on a logarithmic axis, is a gap
  std::vector<double> x = {};  ///< as many as `y`; empty: 0, 1, 2 …
  std::string colour = {};     ///< of SVG, "#d62728"; empty: the next of a palette of eight
};

/// An axis of a plot.
struct PlotAxis {
  std::string label = {};
  bool is_logarithmic = false;
};

/// What is drawn round the curves.
struct PlotOptions {
  std::string title = {};
  PlotAxis x{"iteration"};
  PlotAxis y = {};
  int width = 640;   ///< pixels of the picture
  int height = 420;  ///< pixels
};

/// A line plot as the text of an SVG file: white ground, axes that hold every value, a grid, and a
/// legend. Logarithmic axes are ticked at powers of ten.
std::string svg_plot(const std::vector<Series>& series, const PlotOptions& options);

}  // namespace foldless
