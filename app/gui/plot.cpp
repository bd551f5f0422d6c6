// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/plot_axes.h"
#include "app/gui/plot_lines.h"

namespace foldless {
namespace {

float thickness_of(const Plot& plot) { return std::max(1.5F, plot.font->FontSize / 9); }

/// The pixels of a curve that are in sight, its ends cut where it leaves the axes.
std::vector<ImVec2> points_in_sight(const PlotCurve& curve, const PlotAxes& axes) {
  std::vector<ImVec2> points;
  std::optional<ImVec2> before;
  const auto at_border = [](const ImVec2& a, const ImVec2& b, float x) {
    return ImVec2{x, a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)};
  };
  for (std::size_t i = 0; i < curve.values.size(); ++i) {
    if (!axes.is_drawable(curve.values[i])) continue;
    const ImVec2 point{axes.x(curve.position(i)), axes.y(curve.values[i])};
    if (before && before->x < axes.min.x && point.x > axes.min.x)
      points.push_back(at_border(*before, point, axes.min.x));
    if (axes.is_in_sight(curve.position(i))) points.push_back(point);
    if (point.x > axes.max.x) {
      if (before && before->x < axes.max.x) points.push_back(at_border(*before, point, axes.max.x));
      break;
    }
    before = point;
  }
  return points;
}

/// At most one rectangle a pixel column, so that 100,000 iterations cost what 200 do.
void draw_curve(const PlotCurve& curve, const Plot& plot, const PlotAxes& axes) {
  CurvePen pen(*ImGui::GetWindowDrawList(), curve, thickness_of(plot));
  const std::vector<ImVec2> points = points_in_sight(curve, axes);
  for (std::size_t i = 0; i < points.size();) {
    CurveColumn column{points[i].x, points[i].y, points[i].y, points[i].y, points[i].y};
    const std::size_t first = i++;
    for (; i < points.size() && points[i].x - points[first].x < 1; ++i) {
      column.low = std::min(column.low, points[i].y);
      column.high = std::max(column.high, points[i].y);
      column.last = points[i].y;
    }
    pen.go_on(column);
  }
  pen.finish();
}

void draw_text(const ImVec2& corner, const ImVec4& colour, const std::string& words, ImFont* font) {
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, corner, packed(colour), words.c_str());
}

float width_of(const std::string& words, ImFont* font) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words.c_str(), nullptr).x;
}

std::string short_words(double value) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.4g", value);
  return number.data();
}

void draw_ticks(const Plot& plot, const PlotAxes& axes, const Palette& palette) {
  const float line_height = plot.font->FontSize;
  for (const PlotTick& tick : axes.ticks(line_height * 1.5F)) {
    const float y = axes.y(tick.value);
    ImGui::GetWindowDrawList()->AddLine({axes.min.x, y}, {axes.max.x, y},
                                        packed(palette.border, 0.7F));
    draw_text({axes.min.x - width_of(tick.label, plot.font) - 4, y - line_height / 2}, palette.dim,
              tick.label, plot.font);
  }
}

/// Numbers below the axis, each as far as it has room.
void draw_positions(const Plot& plot, const PlotAxes& axes, const Palette& palette) {
  const auto ticks = axes.position_ticks(plot.font->FontSize * 4);
  float free = axes.min.x - plot.font->FontSize;
  for (const PlotTick& tick : ticks) {
    const bool is_last = &tick == &ticks.back();
    const std::string words = is_last ? tick.label + plot.unit : tick.label;
    const float width = width_of(words, plot.font);
    const float x = std::min(axes.x(tick.value) - width / 2, axes.max.x - width);
    if (x < free) continue;
    free = x + width + plot.font->FontSize / 2;
    draw_text({x, axes.max.y + plot.font->FontSize * 0.2F}, palette.dim, words, plot.font);
  }
}

/// The title, and the value of a single curve at the right.
void draw_heading(const Plot& plot, const ImVec2& corner, const Palette& palette,
                  std::optional<std::size_t> shown) {
  draw_text(corner, palette.dim, plot.title, plot.font);
  if (plot.curves.size() != 1 || plot.curves.front().values.empty()) return;
  const auto& values = plot.curves.front().values;
  const std::string number =
      short_words(values[std::min(shown.value_or(values.size() - 1), values.size() - 1)]);
  draw_text({corner.x + plot.size.x - width_of(number, plot.font), corner.y}, palette.text, number,
            plot.font);
}

/// The values of several curves under the mouse.
void draw_values(const Plot& plot, std::size_t index) {
  ImGui::BeginTooltip();
  ImGui::Text("Iteration %zu", index + 1);
  for (const PlotCurve& curve : plot.curves)
    if (index < curve.values.size())
      ImGui::TextColored(curve.colour, "%s: %s", curve.name.c_str(),
                         short_words(curve.values[index]).c_str());
  ImGui::EndTooltip();
}

void draw_cursor(const PlotAxes& axes, double position, const Palette& palette) {
  if (!axes.is_in_sight(position)) return;
  const float x = axes.x(position);
  ImGui::GetWindowDrawList()->AddLine({x, axes.min.y}, {x, axes.max.y}, packed(palette.text, 0.6F));
}

/// Of an iteration on the longest curve.
double position_of(const Plot& plot, std::size_t index) {
  for (const PlotCurve& curve : plot.curves)
    if (index < curve.values.size()) return curve.position(index);
  return 0;
}

/// Whether the wheel or a double click on the last item changed what is seen.
bool take_zoom(const Plot& plot, const PlotAxes& axes) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!plot.zoom || !ImGui::IsItemHovered()) return false;
  const bool is_reset = ImGui::IsMouseDoubleClicked(0) && !plot.zoom->is_whole();
  if (is_reset) *plot.zoom = {};
  if (!io.KeyCtrl) return is_reset;
  ImGui::SetItemUsingMouseWheel();
  if (io.MouseWheel == 0) return is_reset;
  constexpr double kNotch = 1.25;
  const double place = (axes.position_at(io.MousePos.x) - axes.first) / (axes.last - axes.first);
  *plot.zoom = zoomed(*plot.zoom, place, std::pow(kNotch, -io.MouseWheel));
  return true;
}

void draw_curves(const Plot& plot, const PlotAxes& axes, const Palette& palette) {
  draw_ticks(plot, axes, palette);
  draw_positions(plot, axes, palette);
  for (const PlotCurve& curve : plot.curves) draw_curve(curve, plot, axes);
}

}  // namespace

std::optional<std::size_t> draw_plot(const Plot& plot, const Palette& palette) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(plot.id, plot.size);
  PlotAxes axes = axes_of(plot, corner);
  if (axes.count > 0 && take_zoom(plot, axes)) axes = axes_of(plot, corner);
  ImGui::GetWindowDrawList()->AddRectFilled(axes.min, axes.max, packed(palette.frame, 0.45F), 3);
  std::optional<std::size_t> hovered;
  if (axes.count > 0 && (ImGui::IsItemHovered() || ImGui::IsItemActive()))
    hovered = index_near(plot, axes.position_at(ImGui::GetIO().MousePos.x));
  draw_heading(plot, corner, palette, hovered ? hovered : plot.cursor);
  if (axes.count == 0) return std::nullopt;
  draw_curves(plot, axes, palette);
  if (const auto marked = hovered ? hovered : plot.cursor)
    draw_cursor(axes, position_of(plot, *marked), palette);
  if (hovered && plot.curves.size() > 1) draw_values(plot, *hovered);
  return ImGui::IsItemActive() ? hovered : std::nullopt;
}

void draw_line_sample(const PlotCurve& curve, const ImVec2& from, const ImVec2& to,
                      float thickness) {
  CurvePen pen(*ImGui::GetWindowDrawList(), curve, thickness);
  pen.go_on({from.x, from.y, from.y, from.y, from.y});
  pen.go_on({to.x, to.y, to.y, to.y, to.y});
}

}  // namespace foldless
