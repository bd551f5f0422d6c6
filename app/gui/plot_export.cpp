// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_export.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "app/editor/convergence.h"
#include "app/editor/race_table.h"
#include "app/export/svg_plot.h"
#include "app/gui/theme.h"
#include "core/files/iterations_csv.h"

namespace foldless {
namespace {

// Pixels of one plot.
constexpr int kWidth = 640;
constexpr int kHeight = 420;

/// As on screen in the light theme: the pictures have a white ground too.
std::string colour_of(std::size_t index) {
  const auto& series = light_palette().series;
  const ImVec4& c = series[index % series.size()];
  const auto byte = [](float part) { return static_cast<unsigned>(std::lround(part * 255)); };
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", byte(c.x), byte(c.y), byte(c.z));
  return text.data();
}

std::vector<Series> curves_of(const Editor& editor, const ConvergenceSeries& series) {
  std::vector<Series> curves;
  if (!editor.race().is_open()) {
    const auto& iterations = editor.playback().iterations();
    curves.push_back({"", values_of(series, iterations, iterations.size()), {}, colour_of(0)});
    return curves;
  }
  const Race& race = editor.race();
  for (std::size_t i = 0; i < race.lanes().size(); ++i)
    curves.push_back({race.lanes()[i]->title(),
                      values_of(series, race.lanes()[i]->records(), race.furthest()),
                      {},
                      colour_of(i)});
  return curves;
}

/// Pictures of one size in one picture, two a row.
std::string grid_of(const std::vector<std::string>& pictures) {
  const int columns = pictures.size() > 1 ? 2 : 1;
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  const auto pair = [](const char* a, int x, const char* b, int y) {
    return std::string(" ") + a + "=\"" + std::to_string(x) + "\" " + b + "=\"" +
           std::to_string(y) + "\"";
  };
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
                     pair("width", columns * kWidth, "height", rows * kHeight) + ">\n";
  const std::string opening = "<svg";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    text += opening + pair("x", column * kWidth, "y", row * kHeight) +
            pictures[i].substr(opening.size());
  }
  return text + "</svg>\n";
}

}  // namespace

std::string convergence_csv(const Editor& editor) {
  return editor.race().is_open() ? race_records_csv(editor.race())
                                 : iterations_csv(editor.playback().iterations());
}

std::string convergence_svg(const Editor& editor, std::span<const bool> shown) {
  const auto series = convergence_series();
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < series.size() && i < shown.size(); ++i) {
    if (!shown[i]) continue;
    PlotOptions options;
    options.title = series[i].title;
    options.y.is_logarithmic = series[i].is_logarithmic;
    options.width = kWidth;
    options.height = kHeight;
    plots.push_back(svg_plot(curves_of(editor, series[i]), options));
  }
  return grid_of(plots);
}

}  // namespace foldless
