// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/round_ticks.h"

namespace foldless {
namespace {

std::string tick_words(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

void append_round_ticks(std::vector<PlotTick>& ticks, double low, double high, double step) {
  for (const double value : multiples(step, low, high)) ticks.push_back({value, tick_words(value)});
}

/// What of the positions is seen.
void fit_positions(PlotAxes& axes, const Plot& plot) {
  double first = INFINITY, last = -INFINITY;
  for (const PlotCurve& curve : plot.curves) {
    if (curve.values.empty()) continue;
    first = std::min(first, curve.position(0));
    last = std::max(last, curve.position(curve.values.size() - 1));
    axes.has_whole_positions = curve.positions.empty();
  }
  if (first > last) return;
  if (first == last) last = axes.has_whole_positions ? first + 1 : std::max(2 * first, 1e-9);
  const PlotZoom zoom = plot.zoom ? *plot.zoom : PlotZoom{};
  axes.first = first + zoom.first * (last - first);
  axes.last = first + zoom.last * (last - first);
}

/// The decades of what is positive; zeros, which have none, are drawn one decade lower.
void fit_decades(PlotAxes& axes, const Plot& plot) {
  std::vector<double> ends;
  for (const PlotCurve& curve : plot.curves)
    for (const double value : curve.values) {
      if (axes.is_drawable(value)) ends.push_back(value);
      axes.has_zero = axes.has_zero || value == 0;
    }
  const DecadeRange range = decades_of(ends);
  axes.low = range.low - (axes.has_zero ? 1 : 0);
  axes.high = range.high;
}

/// From zero, or from below where values are negative, to a little more than the largest.
void fit_range(PlotAxes& axes, const Plot& plot) {
  double high = 0;
  for (const PlotCurve& curve : plot.curves)
    for (const double value : curve.values) {
      if (!std::isfinite(value)) continue;
      axes.low = std::min(axes.low, value);
      high = std::max(high, value);
    }
  axes.high = high > axes.low ? high : axes.low + 1;
}

}  // namespace

float PlotAxes::x(double position) const {
  return min.x + static_cast<float>((position - first) / (last - first)) * (max.x - min.x);
}

float PlotAxes::y(double value) const {
  if (has_zero && value == 0) return max.y;
  const double place = ((is_logarithmic ? std::log10(value) : value) - low) / (high - low);
  return max.y - static_cast<float>(place) * (max.y - min.y);
}

bool PlotAxes::is_drawable(double value) const {
  return std::isfinite(value) && (!is_logarithmic || value > 0 || (has_zero && value == 0));
}

double PlotAxes::position_at(float x) const {
  const double place = (x - min.x) / std::max(1.0F, max.x - min.x);
  return first + std::clamp(place, 0.0, 1.0) * (last - first);
}

std::vector<PlotTick> PlotAxes::ticks(float distance) const {
  const double fit = std::max(1.0, std::floor(static_cast<double>((max.y - min.y) / distance)));
  std::vector<PlotTick> ticks;
  if (is_logarithmic) {
    const int stride = static_cast<int>(std::ceil((high - low) / fit));
    if (has_zero) ticks.push_back({0, "0"});
    const int lowest = static_cast<int>(low) + (has_zero ? stride : 0);
    for (int e = lowest; e <= static_cast<int>(high); e += stride)
      ticks.push_back({std::pow(10.0, e), power_of_ten(e)});
    return ticks;
  }
  append_round_ticks(ticks, low, high, round_step((high - low) / fit));
  return ticks;
}

std::vector<PlotTick> PlotAxes::position_ticks(float distance) const {
  const double fit = std::max(1.0, std::floor(static_cast<double>((max.x - min.x) / distance)));
  double step = round_step((last - first) / fit);
  if (has_whole_positions) step = std::max(1.0, step);
  std::vector<PlotTick> ticks;
  append_round_ticks(ticks, first, last, step);
  return ticks;
}

std::size_t index_near(const Plot& plot, double position) {
  const PlotCurve& curve = *std::ranges::max_element(
      plot.curves, {}, [](const PlotCurve& c) { return c.values.size(); });
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < curve.values.size(); ++i)
    if (std::abs(curve.position(i) - position) < std::abs(curve.position(nearest) - position))
      nearest = i;
  return nearest;
}

PlotZoom zoomed(const PlotZoom& zoom, double place, double factor) {
  constexpr double kLeast = 1e-4;
  const double length = std::clamp((zoom.last - zoom.first) * factor, kLeast, 1.0);
  const double fixed = zoom.first + place * (zoom.last - zoom.first);
  const double first = std::clamp(fixed - place * length, 0.0, 1 - length);
  return {first, first + length};
}

PlotAxes axes_of(const Plot& plot, const ImVec2& corner) {
  const float line_height = plot.font->FontSize;
  PlotAxes axes;
  axes.min = {corner.x + line_height * 2.6F, corner.y + line_height * 1.6F};
  axes.max = {corner.x + plot.size.x - line_height * 0.4F,
              corner.y + plot.size.y - line_height * 1.5F};
  axes.is_logarithmic = plot.is_logarithmic;
  for (const PlotCurve& curve : plot.curves) axes.count = std::max(axes.count, curve.values.size());
  fit_positions(axes, plot);
  if (plot.is_logarithmic)
    fit_decades(axes, plot);
  else
    fit_range(axes, plot);
  return axes;
}

DecadeRange decades_of(std::span<const double> values) {
  double low = INFINITY, high = 0;
  for (const double value : values) {
    if (!std::isfinite(value) || value <= 0) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (high <= 0) return {};
  const int bottom = static_cast<int>(std::floor(std::log10(low)));
  const int top = static_cast<int>(std::ceil(std::log10(high)));
  return {bottom, std::max(top, bottom + 1)};
}

std::string power_of_ten(int exponent) {
  static constexpr std::array kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace foldless
