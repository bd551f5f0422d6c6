// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/plot_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace foldless {
namespace {

/// Lengths of dash, gap, dash, gap in line widths; the pattern repeats.
using Pattern = std::array<float, 4>;

constexpr Pattern pattern_of(LineStyle style) {
  switch (style) {
    case LineStyle::dashed: return {5, 3, 5, 3};
    case LineStyle::dotted: return {1.3F, 2.2F, 1.3F, 2.2F};
    case LineStyle::dash_dotted: return {6, 2.5F, 1.3F, 2.5F};
    case LineStyle::solid: break;
  }
  return {1, 0, 1, 0};
}

/// What is left of the part of the pattern at a place along the curve.
struct PatternPlace {
  bool is_ink;
  float rest;
};

PatternPlace place_in(const Pattern& pattern, float unit, float travelled) {
  const float length = unit * (pattern[0] + pattern[1] + pattern[2] + pattern[3]);
  float along = std::fmod(travelled, length);
  for (std::size_t part = 0; part < pattern.size(); ++part) {
    if (along < unit * pattern[part]) return {part % 2 == 0, unit * pattern[part] - along};
    along -= unit * pattern[part];
  }
  return {true, unit * pattern[0]};
}

}  // namespace

CurvePen::CurvePen(ImDrawList& list, const PlotCurve& curve, float thickness)
    : list_(list), style_(curve.style), colour_(packed(curve.colour)), thickness_(thickness) {}

void CurvePen::go_on(const CurveColumn& column) {
  // Where rectangles leave no gap they show what a line and a stroke do, with two triangles instead
  // of twelve.
  const bool is_next = last_ && column.x - last_->x <= thickness_ && style_ == LineStyle::solid;
  float low = column.low, high = column.high;
  if (is_next) {
    low = std::min(low, last_->y);
    high = std::max(high, last_->y);
  } else {
    line_to({column.x, column.first});
  }
  const float half = thickness_ / 2;
  if (is_next || high > low)
    list_.AddRectFilled({column.x - half, low - half}, {column.x + half, high + half}, colour_);
  last_ = ImVec2{column.x, column.last};
}

void CurvePen::line_to(const ImVec2& point) {
  if (last_ && style_ == LineStyle::solid) list_.AddLine(*last_, point, colour_, thickness_);
  if (last_ && style_ != LineStyle::solid) dashes(*last_, point);
}

void CurvePen::dashes(const ImVec2& from, const ImVec2& to) {
  // Less than this is lost to rounding, and would not get on.
  constexpr float kLeast = 0.05F;
  const Pattern pattern = pattern_of(style_);
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  const auto at = [&](float s) {
    return ImVec2{from.x + (to.x - from.x) * s / length, from.y + (to.y - from.y) * s / length};
  };
  for (float done = 0; done < length;) {
    const PatternPlace place = place_in(pattern, thickness_, travelled_);
    const float step = std::min(std::max(place.rest, kLeast), length - done);
    if (place.is_ink) list_.AddLine(at(done), at(done + step), colour_, thickness_);
    done += step;
    travelled_ += step;
    if (step < kLeast) break;
  }
}

void CurvePen::finish() {
  if (last_) list_.AddCircleFilled(*last_, thickness_ * 1.6F, colour_);
}

}  // namespace foldless
