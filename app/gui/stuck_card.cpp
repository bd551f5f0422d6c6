// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// Draws on the canvas, under all panels.
struct CanvasPen {
  const Editor& editor;
  const Rectangle& place;
  const Look& look;

  ImVec2 at(const Vec2& world) const {
    const Vec2 pixel = editor.canvas().to_pixel(world);
    return {place.x + static_cast<float>(pixel.x()), place.y + static_cast<float>(pixel.y())};
  }
  /// A line that can be seen on every fill.
  void line(const ImVec2& from, const ImVec2& to, const ImVec4& colour, float width) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine(from, to, IM_COL32_BLACK, look.px(width + 2));
    list.AddLine(from, to, packed(colour), look.px(width));
  }
};

/// From the vertex along its way, as long as can be seen, with a head.
void draw_arrow(const StuckHandle& handle, const CanvasPen& pen) {
  const ImVec2 from = pen.at(handle.position);
  const ImVec2 target = pen.at(handle.target);
  const Vec2 way(target.x - from.x, target.y - from.y);
  const double length = way.norm();
  if (length < 1) return;
  const Vec2 along = way / length;
  const Vec2 across(-along.y(), along.x());
  const double reach = std::min(length, static_cast<double>(pen.look.px(64)));
  const double head = pen.look.px(11);
  const auto at = [&](double forward, double aside) {
    const Vec2 p = Vec2(from.x, from.y) + forward * along + aside * across;
    return ImVec2{static_cast<float>(p.x()), static_cast<float>(p.y())};
  };
  const ImVec4& colour = pen.look.palette->accent;
  pen.line(from, at(reach - head * 0.8, 0), colour, 3);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddTriangleFilled(at(reach + 2, 0), at(reach - head - 2, head * 0.75),
                         at(reach - head - 2, -head * 0.75), IM_COL32_BLACK);
  list.AddTriangleFilled(at(reach, 0), at(reach - head, head * 0.55),
                         at(reach - head, -head * 0.55), packed(colour));
}

void draw_blocking(const StuckHandle& handle, bool is_current, const CanvasPen& pen) {
  const Points& points = pen.editor.document().pose->deformed;
  for (const Edge& edge : handle.blocking)
    pen.line(pen.at(points.col(edge[0])), pen.at(points.col(edge[1])), pen.look.palette->caution,
             is_current ? 4.0F : 2.0F);
}

void draw_buttons(Editor& editor, const StuckHandle& handle, const Look& look) {
  // Running a command changes the handles.
  const bool can_flip = handle.can_flip, can_split = handle.can_split;
  ImGui::BeginDisabled(!can_flip);
  const bool flips = ImGui::Button("Flip");
  ImGui::EndDisabled();
  tooltip(can_flip ? "Flips the edges in the way, an undo step (Shift+F)."
                   : "A triangle would fold: these edges cannot be flipped.",
          look);
  ImGui::SameLine();
  ImGui::BeginDisabled(!can_split);
  const bool splits = ImGui::Button("Split here");
  ImGui::EndDisabled();
  tooltip(can_split ? "Splits edges as the paper's rule does, so that the vertex gets through: an "
                      "undo step (Shift+S)."
                    : "No edge here can be split: they would become too short.",
          look);
  ImGui::SameLine();
  const bool closes = ImGui::Button("Do not tell");
  tooltip("Hides this; W tells again.", look);
  if (flips) editor.run_command("stuck.flip");
  if (splits) editor.run_command("stuck.split");
  if (closes) editor.run_command("stuck.toggle");
}

void draw_card(Editor& editor, const StuckHandle& handle, const PanelContext& context) {
  const Look& look = context.look;
  const Rectangle& canvas = context.layout.canvas;
  const float width = std::min(look.px(430), canvas.width - look.px(20));
  ImGui::SetNextWindowPos({canvas.x + canvas.width / 2, canvas.y + canvas.height - look.px(12)},
                          ImGuiCond_Always, {0.5F, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.95F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->popup);
  if (ImGui::Begin("##stuck", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                       ImGuiWindowFlags_NoFocusOnAppearing)) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(words_of(handle).c_str());
    ImGui::PopTextWrapPos();
    const std::size_t others = editor.stuck().handles().size() - 1;
    if (others > 0)
      dim_text(std::to_string(others) + " more of them; select a handle to see why.", look);
    draw_buttons(editor, handle, look);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace

void draw_stuck_card(Editor& editor, const PanelContext& context) {
  const StuckHandle* current = editor.stuck().handle();
  if (!current || editor.view().are_overlays_hidden()) return;
  const Rectangle& canvas = context.layout.canvas;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({canvas.x, canvas.y}, {canvas.x + canvas.width, canvas.y + canvas.height});
  const CanvasPen pen{editor, canvas, context.look};
  for (const StuckHandle& handle : editor.stuck().handles())
    draw_blocking(handle, &handle == current, pen);
  draw_arrow(*current, pen);
  list.PopClipRect();
  draw_card(editor, *current, context);
}

}  // namespace foldless
