// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/blend.h"
#include "render/colormap.h"
#include "render/stroke_font.h"
#include "render/theme.h"

namespace foldless {
namespace {

constexpr double kWidth = 104;  // design pixels, here and below
constexpr double kBarWidth = 14;
constexpr double kBarHeight = 280;
constexpr double kGap = 7;
constexpr double kDigit = 10;
constexpr double kTickDistance = 22;

std::string words(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), value >= 1000 && value < 1e6 ? "%.0f" : "%.3g", value);
  return text.data();
}

LegendTick tick_at(const HeatRange& range, double value) {
  return {position_on(range, value), words(value)};
}

/// The multiples of powers of ten strictly inside the scale, not too near to its ends.
std::vector<LegendTick> round_ticks(const HeatRange& range, const std::vector<double>& multiples) {
  std::vector<LegendTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.min)));
  const int last = static_cast<int>(std::ceil(std::log10(range.max)));
  for (int power = first; power <= last; ++power)
    for (const double multiple : multiples) {
      const double value = multiple * std::pow(10.0, power);
      const LegendTick tick = tick_at(range, value);
      if (value > range.min && value < range.max && tick.t > 0.06 && tick.t < 0.94)
        ticks.push_back(tick);
    }
  return ticks;
}

void draw_bar(Image& image, const LegendBar& bar, const glm::vec4& frame) {
  for (int y = -1; y <= bar.height; ++y)
    for (int x = -1; x <= bar.width; ++x) {
      const bool is_frame = x < 0 || y < 0 || x == bar.width || y == bar.height;
      const float t = 1 - (static_cast<float>(y) + 0.5F) / static_cast<float>(bar.height);
      blend(image, bar.left + x, bar.top + y, is_frame ? frame : glm::vec4(viridis(t), 1));
    }
}

/// The bar without its numbers, at the right border in the middle.
LegendBar bar_of(int width, int height, double scale) {
  const int long_side = std::min(static_cast<int>(kBarHeight * scale), height * 6 / 10);
  return {width - legend_width(scale) + static_cast<int>(kGap * scale), (height - long_side) / 2,
          static_cast<int>(kBarWidth * scale), long_side};
}

}  // namespace

std::vector<LegendTick> legend_ticks(const HeatRange& range, int at_most) {
  const auto room = static_cast<std::size_t>(std::max(at_most - 2, 0));
  std::vector<LegendTick> inside = round_ticks(range, {1, 2, 5});
  if (inside.size() > room) inside = round_ticks(range, {1});
  if (inside.size() > room) inside.clear();
  if (inside.empty() && room >= 1) inside.push_back(tick_at(range, value_at(range, 0.5)));
  std::vector<LegendTick> ticks{{0, words(range.min)}};
  ticks.insert(ticks.end(), inside.begin(), inside.end());
  ticks.push_back({1, words(range.max)});
  return ticks;
}

int legend_width(double ui_scale) { return static_cast<int>(kWidth * ui_scale); }

std::optional<Legend> legend_of(int width, int height, const HeatRange& range,
                                const ViewOptions& style) {
  const double scale = style.ui_scale, digit = kDigit * scale;
  Legend legend;
  legend.bar = bar_of(width, height, scale);
  const LegendBar& bar = legend.bar;
  if (bar.left < 1 || bar.width < 1 || bar.height < 1) return std::nullopt;
  legend.mark_length = static_cast<int>(4 * scale);
  legend.colour = canvas_colours(style.theme).text;
  const int count = static_cast<int>(bar.height / (kTickDistance * scale));
  const double left = bar.left + bar.width + legend.mark_length + 0.7 * kGap * scale;
  for (const LegendTick& tick : legend_ticks(range, std::max(count, 2))) {
    const double y = bar.top + (1 - tick.t) * bar.height;
    legend.marks.push_back(y);
    legend.texts.push_back(
        {tick.label, {{left, std::round(y + 0.5 * digit)}, digit, legend.colour}});
  }
  constexpr std::array kTitles{"s1/s2", "A'/A", "E/A"};  // in the order of HeatMeasure
  const glm::dvec2 baseline(bar.left, bar.top - 16 * scale);
  legend.texts.push_back(
      {kTitles[static_cast<std::size_t>(range.measure)], {baseline, digit, legend.colour}});
  return legend;
}

void draw_legend(Image& image, const HeatRange& range, const ViewOptions& style) {
  const auto legend = legend_of(image.width, image.height, range, style);
  if (!legend) return;
  const LegendBar& bar = legend->bar;
  draw_bar(image, bar, legend->colour);
  for (const double y : legend->marks)
    for (int x = 0; x < legend->mark_length; ++x)
      blend(image, bar.left + bar.width + x, static_cast<int>(y - 0.5), legend->colour);
  for (const LegendText& text : legend->texts) draw_stroke_text(image, text.words, text.place);
}

}  // namespace foldless
