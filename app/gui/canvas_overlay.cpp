// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/canvas_overlay.h"

#include <algorithm>
#include <string>

#include "app/editor/picking.h"
#include "app/gui/canvas_brush.h"
#include "app/gui/short_text.h"
#include "app/gui/side_dialog.h"
#include "app/gui/widgets.h"
#include "core/mesh/triangle.h"

namespace foldless {
namespace {

/// Black on white can be seen on every colour.
void draw_band(const PixelBox& band, const CanvasBrush& brush, const Look& look) {
  const ImVec2 low = brush.at(band.min), high = brush.at(band.max);
  brush.list.AddRectFilled(low, high, packed(look.palette->accent, 0.12F));
  brush.list.AddRect(low, high, IM_COL32_WHITE, 0, 0, look.px(3));
  brush.list.AddRect(low, high, IM_COL32_BLACK, 0, 0, look.px(1));
}

void draw_lasso(const std::vector<Vec2>& line, const CanvasBrush& brush, const Look& look) {
  std::vector<ImVec2> points;
  points.reserve(line.size());
  for (const Vec2& pixel : line) points.push_back(brush.at(pixel));
  const int count = static_cast<int>(points.size());
  brush.list.AddPolyline(points.data(), count, IM_COL32_WHITE, ImDrawFlags_Closed, look.px(3));
  brush.list.AddPolyline(points.data(), count, IM_COL32_BLACK, ImDrawFlags_Closed, look.px(1));
}

void draw_distances(const Editor& editor, const CanvasBrush& brush, const Look& look) {
  for (const HandleView& handle : handle_views(editor.draft())) {
    if (handle.is_at_target) continue;
    const Vec2 target = editor.canvas().to_pixel(handle.target);
    const Vec2 position = editor.canvas().to_pixel(handle.position);
    if ((target - position).norm() < 12 * editor.canvas().ui_scale) continue;
    const ImVec2 place = brush.at(target);
    draw_plate(short_number(handle.residual, 3), {place.x, place.y - look.px(20)}, brush, look);
  }
}

Vec2 centroid(const Snapshot& snapshot, int triangle) {
  const Eigen::Vector3i corners = snapshot.triangles->col(triangle);
  return (snapshot.deformed.col(corners[0]) + snapshot.deformed.col(corners[1]) +
          snapshot.deformed.col(corners[2])) /
         3;
}

double heat_of(const Snapshot& snapshot, const Density& energy, HeatMeasure measure, int triangle) {
  const Mat2 J =
      deformation_gradient(*snapshot.rest, snapshot.deformed, snapshot.triangles->col(triangle));
  if (measure == HeatMeasure::energy) return energy.value(J);
  const Vec2 sigma = signed_singular_values(J);
  return measure == HeatMeasure::conformal ? sigma[0] / sigma[1] : sigma[0] * sigma[1];
}

/// Marks the largest value and tells the one under the pointer.
void draw_heat_notes(Editor& editor, const PanelContext& context, const CanvasBrush& brush) {
  UiState& state = context.state;
  state.hovered_heat.reset();
  if (!state.heat_range) return;
  const Snapshot& snapshot = *editor.shown();
  if (state.pointer) {
    const auto under = triangle_at(snapshot, editor.canvas().to_world(*state.pointer),
                                   editor.draft().paint_order());
    if (under)
      state.hovered_heat =
          heat_of(snapshot, *editor.document().energy, state.heat_range->measure, *under);
  }
  const int triangle = state.heat_range->triangle_at_max;
  if (triangle == kElsewhere || triangle >= snapshot.triangles->cols()) return;
  const Look& look = context.look;
  const ImVec2 place = brush.at(editor.canvas().to_pixel(centroid(snapshot, triangle)));
  brush.list.AddCircle(place, look.px(9), IM_COL32_BLACK, 0, look.px(3.4F));
  brush.list.AddCircle(place, look.px(9), IM_COL32_WHITE, 0, look.px(1.6F));
  draw_plate("max " + short_number(state.heat_range->max, 3), {place.x, place.y + look.px(22)},
             brush, look);
}

/// What the stiffness brush covers where the pointer is.
void draw_brush(const Editor& editor, const CanvasBrush& brush, const PanelContext& context) {
  if (!context.state.pointer) return;
  const Look& look = context.look;
  const ImVec2 centre = brush.at(*context.state.pointer);
  const auto radius = static_cast<float>(editor.brush().radius() * editor.canvas().ui_scale);
  brush.list.AddCircle(centre, radius, IM_COL32_BLACK, 0, look.px(3));
  brush.list.AddCircle(centre, radius, IM_COL32_WHITE, 0, look.px(1.4F));
}

/// What to look at or to try, in the words of the scene, until it is closed.
void draw_description(const std::string& words, const PanelContext& context) {
  if (words.empty() || words == context.state.closed_description) return;
  const Look& look = context.look;
  const Rectangle& canvas = context.layout.canvas;
  const float width = std::min(canvas.width - look.px(28), look.px(580));
  ImGui::SetNextWindowPos({canvas.x + canvas.width / 2, canvas.y + look.px(10)}, ImGuiCond_Always,
                          {0.5F, 0});
  ImGui::SetNextWindowBgAlpha(0.85F);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->popup);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{look.px(10), look.px(5)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2{1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(6));
  ImGui::Begin("##description", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PushFont(look.fonts.small);
  ImGui::PushTextWrapPos(width - look.px(40));
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SameLine();
  if (ImGui::SmallButton("×")) context.state.closed_description = words;
  tooltip("Close", look);
  ImGui::PopFont();
  ImGui::End();
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor();
}

/// A line over the top of the canvas.
void draw_plate_on_top(const std::string& words, const CanvasBrush& brush, const Look& look) {
  if (words.empty()) return;
  const float margin = look.px(14);
  const float width = std::min(brush.canvas.width - 2 * margin, look.px(560));
  ImFont* font = look.fonts.small;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, width, words.c_str(), nullptr);
  const ImVec2 corner{brush.canvas.x + (brush.canvas.width - size.x) / 2, brush.canvas.y + margin};
  brush.list.AddRectFilled({corner.x - look.px(10), corner.y - look.px(5)},
                           {corner.x + size.x + look.px(10), corner.y + size.y + look.px(5)},
                           packed(look.palette->popup, 0.85F), look.px(6));
  brush.list.AddText(font, font->FontSize, corner, packed(look.palette->text), words.c_str(),
                     nullptr, width);
}

}  // namespace

void draw_preview_overlay(const Preview& preview, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle place = preview_place(context.layout, look.scale);
  draw_plate_on_top(preview.words, {*ImGui::GetBackgroundDrawList(), place}, look);
}

void draw_canvas_overlay(Editor& editor, const PanelContext& context) {
  if (!editor.shown()) return;
  const Rectangle& canvas = context.layout.canvas;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const CanvasBrush brush{list, canvas};
  list.PushClipRect({canvas.x, canvas.y}, {canvas.x + canvas.width, canvas.y + canvas.height});
  if (editor.comparison().is_held()) {
    const bool is_kept = editor.comparison().kept() != nullptr;
    draw_plate_on_top(is_kept ? "The kept pose" : "The rest shape", brush, context.look);
    return list.PopClipRect();
  }
  if (!editor.view().are_overlays_hidden()) draw_outlines(editor, brush, context.look);
  if (editor.view().shown_options().layers.handles) {
    draw_mirror(editor, brush, context.look);
    draw_swings(editor, brush, context.look);
    draw_bones(editor, brush, context);
  }
  draw_heat_notes(editor, context, brush);
  if (editor.view().shown_options().layers.handles) draw_distances(editor, brush, context.look);
  if (!editor.view().are_overlays_hidden()) draw_handle_notes(editor, brush, context);
  if (!editor.draft().is_editing() && !editor.view().are_overlays_hidden() &&
      editor.view().beside() == Beside::nothing)
    draw_description(editor.document().description, context);
  if (editor.brush().is_on()) draw_brush(editor, brush, context);
  if (const auto band = editor.input().band()) draw_band(*band, brush, context.look);
  draw_lasso(editor.input().lasso(), brush, context.look);
  list.PopClipRect();
}

}  // namespace foldless
