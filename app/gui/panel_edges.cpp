// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of the side panels and of the time line, which are dragged to make them larger.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/gui/panels.h"

namespace foldless {
namespace {

/// Half the stripe that is caught by the pointer: so much lies over the panel. [design pixels]
constexpr float kHalfGrip = 3;

constexpr ImGuiWindowFlags kEdgeWindow =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav |
    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing;

/// An edge of a panel, and the width that it changes.
struct PanelEdge {
  const char* id;
  const Rectangle& panel;
  bool is_left = false;  ///< the panel lies left of its edge
  double PanelWidths::*width;
};

/// Where the edge is; without a panel there is none.
float line_of(const PanelEdge& edge) {
  return edge.is_left ? edge.panel.x + edge.panel.width : edge.panel.x;
}

/// Whole pixels, as windows have.
float half_grip(const Look& look) { return std::round(look.px(kHalfGrip)); }

void drag(const PanelEdge& edge, const PanelContext& context) {
  if (ImGui::GetIO().MouseDelta.x == 0) return;
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  const float line = imgui.IO.MousePos.x - imgui.ActiveIdClickOffset.x + half_grip(context.look);
  const float width = edge.is_left ? line - edge.panel.x : edge.panel.x + edge.panel.width - line;
  double& design = context.state.settings.panel_widths.*edge.width;
  design = std::clamp(std::round(static_cast<double>(width / context.look.scale)),
                      kNarrowestPanels.*edge.width, kWidestPanels.*edge.width);
}

/// A window that has nothing but an item; ImGui::End() must follow.
void begin_grip(const char* id, const Rectangle& place) {
  ImGui::SetNextWindowPos({place.x, place.y});
  ImGui::SetNextWindowSize({place.width, place.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  ImGui::Begin(id, nullptr, kEdgeWindow);
  ImGui::PopStyleVar(2);
  ImGui::InvisibleButton("##grip", {place.width, place.height});
}

void draw_edge(const PanelEdge& edge, const PanelContext& context) {
  if (edge.panel.width <= 0) return;
  const Look& look = context.look;
  const float half = half_grip(look), line = line_of(edge);
  begin_grip(edge.id, {line - half, edge.panel.y, 2 * half, edge.panel.height});
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    context.state.settings.panel_widths.*edge.width = PanelWidths{}.*edge.width;
  else if (ImGui::IsItemActive())
    drag(edge, context);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled({line - look.px(1), edge.panel.y},
                                              {line + look.px(1), edge.panel.y + edge.panel.height},
                                              packed(look.palette->outline));
  }
  ImGui::End();
}

/// The upper edge of the time line; the grip lies over the canvas alone, as the panel is older and
/// so in front.
void draw_time_line_edge(const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& place = context.layout.timeline;
  const float half = half_grip(look);
  double& height = context.state.settings.time_line_height;
  begin_grip("##time line edge", {place.x, place.y - 2 * half, place.width, 2 * half});
  const ImGuiContext& imgui = *ImGui::GetCurrentContext();
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    height = kTimeLineHeight;
  } else if (ImGui::IsItemActive() && imgui.IO.MouseDelta.y != 0) {
    const float line = imgui.IO.MousePos.y - imgui.ActiveIdClickOffset.y + 2 * half;
    const float by = (place.y - line) / look.scale;
    height = std::clamp(
        std::round(time_line_height(context.layout, look.scale) + static_cast<double>(by)),
        kLowestTimeLine, kHighestTimeLine);
  }
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled({place.x, place.y - look.px(1)},
                                              {place.x + place.width, place.y + look.px(1)},
                                              packed(look.palette->outline));
  }
  ImGui::End();
}

}  // namespace

/// Made before the panels, which lie behind them for that.
void draw_panel_edges(const PanelContext& context) {
  draw_edge({"##left edge", context.layout.left, true, &PanelWidths::left}, context);
  draw_edge({"##right edge", context.layout.right, false, &PanelWidths::right}, context);
  if (time_line_height(context.layout, context.look.scale) > 0) draw_time_line_edge(context);
}

}  // namespace foldless
