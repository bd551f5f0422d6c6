// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace foldless {
namespace {

/// The rectangle of the curve, and what its corners mean.
struct Axes {
  ImVec2 min, max;
  DecadeRange range;
  std::size_t count;

  float x(std::size_t i) const {
    const double last = static_cast<double>(std::max<std::size_t>(count, 2) - 1);
    return min.x + static_cast<float>(static_cast<double>(i) / last) * (max.x - min.x);
  }
  float y(double value) const {
    const double position = (std::log10(value) - range.low) / (range.high - range.low);
    return max.y - static_cast<float>(position) * (max.y - min.y);
  }
};

bool is_drawable(double value) { return std::isfinite(value) && value > 0; }

/// At most one vertical stroke a pixel column, so that 100,000 iterations cost what 200 do.
void draw_curve(const Plot& plot, const Axes& axes, ImDrawList& list) {
  const ImU32 colour = packed(plot.colour);
  const float thickness = std::max(1.5F, plot.font->FontSize / 9);
  std::optional<ImVec2> previous;
  float column_low = 0, column_high = 0;
  for (std::size_t i = 0; i < plot.values.size(); ++i) {
    if (!is_drawable(plot.values[i])) continue;
    const ImVec2 point{axes.x(i), axes.y(plot.values[i])};
    if (previous && point.x - previous->x < 1 && i + 1 < plot.values.size()) {
      column_low = std::min(column_low, point.y);
      column_high = std::max(column_high, point.y);
      continue;
    }
    if (previous) {
      if (column_high > column_low)
        list.AddLine({previous->x, column_low}, {previous->x, column_high}, colour, thickness);
      list.AddLine(*previous, point, colour, thickness);
    }
    previous = point;
    column_low = column_high = point.y;
  }
  if (previous) list.AddCircleFilled(*previous, thickness * 1.6F, colour);
}

void draw_decades(const Plot& plot, const Axes& axes, const Palette& palette) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line_height = plot.font->FontSize;
  const int span = axes.range.high - axes.range.low;
  const int fit = std::max(1, static_cast<int>((axes.max.y - axes.min.y) / (line_height * 1.5F)));
  const int stride = (span + fit - 1) / fit;
  for (int e = axes.range.low; e <= axes.range.high; e += stride) {
    const float y = axes.y(std::pow(10.0, e));
    list.AddLine({axes.min.x, y}, {axes.max.x, y}, packed(palette.border, 0.7F));
    const std::string label = power_of_ten(e);
    const float width = plot.font->CalcTextSizeA(line_height, FLT_MAX, 0, label.c_str(), nullptr).x;
    list.AddText(plot.font, line_height, {axes.min.x - width - 4, y - line_height / 2},
                 packed(palette.dim), label.c_str());
  }
}

void draw_heading(const Plot& plot, const ImVec2& corner, const Palette& palette,
                  std::optional<std::size_t> shown) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(plot.font, plot.font->FontSize, corner, packed(palette.dim), plot.title);
  if (plot.values.empty()) return;
  const std::size_t index =
      std::min(shown.value_or(plot.values.size() - 1), plot.values.size() - 1);
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.4g", plot.values[index]);
  const float width =
      plot.font->CalcTextSizeA(plot.font->FontSize, FLT_MAX, 0, number.data(), nullptr).x;
  list.AddText(plot.font, plot.font->FontSize, {corner.x + plot.size.x - width, corner.y},
               packed(palette.text), number.data());
}

std::size_t index_at(const Axes& axes, float x) {
  const float position = (x - axes.min.x) / std::max(1.0F, axes.max.x - axes.min.x);
  const auto last = static_cast<float>(axes.count - 1);
  return static_cast<std::size_t>(std::lround(std::clamp(position, 0.0F, 1.0F) * last));
}

}  // namespace

DecadeRange decades_of(std::span<const double> values) {
  double low = INFINITY, high = 0;
  for (const double value : values) {
    if (!is_drawable(value)) continue;
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

std::optional<std::size_t> draw_log_plot(const Plot& plot, const Palette& palette) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(plot.id, plot.size);
  const float line_height = plot.font->FontSize;
  const Axes axes{{corner.x + line_height * 2.6F, corner.y + line_height * 1.6F},
                  {corner.x + plot.size.x, corner.y + plot.size.y - line_height * 0.4F},
                  decades_of(plot.values),
                  plot.values.size()};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(axes.min, axes.max, packed(palette.frame, 0.45F), 3);
  const bool is_empty = plot.values.empty();
  std::optional<std::size_t> hovered;
  if (!is_empty && (ImGui::IsItemHovered() || ImGui::IsItemActive()))
    hovered = index_at(axes, ImGui::GetIO().MousePos.x);
  draw_heading(plot, corner, palette, hovered ? hovered : plot.cursor);
  if (is_empty) return std::nullopt;
  draw_decades(plot, axes, palette);
  list.PushClipRect({axes.min.x, axes.min.y - 3}, {axes.max.x + 3, axes.max.y + 3}, true);
  draw_curve(plot, axes, list);
  list.PopClipRect();
  if (const auto marked = hovered ? hovered : plot.cursor) {
    const float x = axes.x(*marked);
    list.AddLine({x, axes.min.y}, {x, axes.max.y}, packed(palette.text, 0.6F));
  }
  return ImGui::IsItemActive() ? hovered : std::nullopt;
}

}  // namespace foldless
