// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/layout.h"

#include <algorithm>
#include <cmath>

namespace foldless {
namespace {

constexpr float kMenuBar = 28;
constexpr float kStatusBar = 25;
constexpr float kTimeline = 40;
constexpr float kStrip = 40;
constexpr float kRuler = 18;
constexpr float kNarrow = 960;  ///< design pixels under which one panel holds all sections

Rulers cut_off_rulers(Rectangle& pane, float wish) {
  const float size = std::min({wish, pane.width, pane.height});
  Rulers rulers;
  rulers.top = {pane.x, pane.y, pane.width, size};
  rulers.left = {pane.x, pane.y + size, size, pane.height - size};
  pane = {pane.x + size, pane.y + size, pane.width - size, pane.height - size};
  return rulers;
}

}  // namespace

Layout layout_for(Extent framebuffer, float scale, SidePanels panels, const PanelWidths& wanted) {
  const auto width = static_cast<float>(framebuffer.width);
  const auto height = static_cast<float>(framebuffer.height);
  const auto px = [scale](double design) { return std::round(static_cast<float>(design) * scale); };
  Layout layout;
  if (panels == SidePanels::two && width < px(kNarrow)) panels = SidePanels::one;
  const float strip = panels != SidePanels::none ? px(kStrip) : 0;
  float left = panels == SidePanels::two ? px(wanted.left) : 0;
  float right = panels != SidePanels::none ? std::min(px(wanted.right), std::round(width / 2)) : 0;
  // Where both are wanted wider than there is room, each gives way by its part of the excess.
  const float room = std::max(0.0F, std::floor(width - strip - width / 3));
  if (left > 0 && left + right > room) {
    const float least_left = px(kNarrowestPanels.left), least_right = px(kNarrowestPanels.right);
    const float part = (left - least_left) / (left - least_left + right - least_right);
    left = std::floor(least_left + (room - least_left - least_right) * part);
    right = room - left;
  }
  const float middle = width - strip - left - right;
  const float bottom = std::max(height - px(kStatusBar), px(kMenuBar));
  const float top = px(kMenuBar);
  const float canvas_bottom = std::max(bottom - px(kTimeline), top);
  layout.menu_bar = {0, 0, width, top};
  layout.strip = {0, top, strip, bottom - top};
  layout.left = {strip, top, left, bottom - top};
  layout.right = {strip + left + middle, top, right, bottom - top};
  layout.canvas = {strip + left, top, middle, canvas_bottom - top};
  layout.timeline = {strip + left, canvas_bottom, middle, bottom - canvas_bottom};
  layout.status_bar = {0, bottom, width, height - bottom};
  return layout;
}

void add_time_line(Layout& layout, float scale, double height) {
  const float wanted = static_cast<float>(height) * scale;
  const float keys = std::round(std::min(wanted, layout.canvas.height / 2));
  layout.canvas.height -= keys;
  layout.timeline.y -= keys;
  layout.timeline.height += keys;
}

double time_line_height(const Layout& layout, float scale) {
  return static_cast<double>((layout.timeline.height - std::round(kTimeline * scale)) / scale);
}

void split_canvas(Layout& layout, float scale) {
  const float line = std::round(2 * scale);
  const float half = std::max(0.0F, std::floor((layout.canvas.width - line) / 2));
  layout.side = layout.canvas;
  layout.side.width = half;
  layout.canvas.x += layout.canvas.width - half;
  layout.canvas.width = half;
}

void add_rulers(Layout& layout, float scale) {
  const float size = std::round(kRuler * scale);
  layout.rulers = cut_off_rulers(layout.canvas, size);
  if (layout.side.width > 0) layout.side_rulers = cut_off_rulers(layout.side, size);
}

}  // namespace foldless
