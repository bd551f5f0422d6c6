// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "app/editor/mesh_place.h"
#include "app/gui/panels.h"
#include "app/gui/view_pane.h"
#include "app/gui/widgets.h"
#include "render/theme.h"

namespace foldless {
namespace {

/// One of the two panes: where it is, and which positions it shows.
struct Pane {
  const Rectangle& place;
  const Canvas& canvas;
  const Points& points;

  ImVec2 at(int vertex) const {
    const Vec2 pixel = canvas.to_pixel(points.col(vertex));
    return {place.x + static_cast<float>(pixel.x()), place.y + static_cast<float>(pixel.y())};
  }
};

ImVec4 colour_of(const glm::vec4& c) { return {c.r, c.g, c.b, c.a}; }

/// Black beside white can be seen on every fill.
void outline(const std::array<ImVec2, 3>& p, int count, const Look& look) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImDrawFlags closed = count == 3 ? ImDrawFlags_Closed : ImDrawFlags_None;
  list.AddPolyline(p.data(), count, IM_COL32_BLACK, closed, look.px(6));
  list.AddPolyline(p.data(), count, IM_COL32_WHITE, closed, look.px(3));
}

void draw_highlight(const MeshPlace& place, const Pane& pane, const Look& look) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({pane.place.x, pane.place.y},
                    {pane.place.x + pane.place.width, pane.place.y + pane.place.height});
  std::array<ImVec2, 3> points{};
  for (std::size_t k = 0; k < place.corners.size(); ++k) points[k] = pane.at(place.corners[k]);
  if (place.corners.size() == 1) {
    list.AddCircle(points[0], look.px(8), IM_COL32_BLACK, 0, look.px(5));
    list.AddCircle(points[0], look.px(8), IM_COL32_WHITE, 0, look.px(2.5F));
  } else {
    if (place.corners.size() == 3)
      list.AddTriangleFilled(points[0], points[1], points[2], packed(look.palette->accent, 0.45F));
    outline(points, static_cast<int>(place.corners.size()), look);
  }
  list.PopClipRect();
}

/// Words in the upper left corner of a pane.
void draw_name(const char* words, const Rectangle& place, const Look& look) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  ImFont* font = look.fonts.bold;
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, words, nullptr);
  const ImVec2 corner{place.x + look.px(14), place.y + look.px(12)};
  list.AddRectFilled({corner.x - look.px(6), corner.y - look.px(3)},
                     {corner.x + size.x + look.px(6), corner.y + size.y + look.px(3)},
                     packed(look.palette->popup, 0.88F), look.px(4));
  list.AddText(font, font->FontSize, corner, packed(look.palette->text), words);
}

/// A sample of the mark, then what it means.
void legend_row(const std::string& words, const glm::vec4& colour, bool is_line, const Look& look) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float middle = corner.y + ImGui::GetTextLineHeight() / 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (is_line)
    list.AddLine({corner.x, middle}, {corner.x + look.px(16), middle}, packed(colour_of(colour)),
                 look.px(3));
  else
    list.AddCircleFilled({corner.x + look.px(8), middle}, look.px(4), packed(colour_of(colour)));
  ImGui::Dummy({look.px(16), 1});
  ImGui::SameLine();
  ImGui::TextUnformatted(words.c_str());
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void draw_legend(const Snapshot& shown, const std::optional<MeshPlace>& hovered,
                 const PanelContext& context) {
  const CanvasColours& colours = canvas_colours(context.state.settings.theme);
  const std::size_t flipped = shown.flipped_edges ? shown.flipped_edges->size() : 0;
  const auto split = static_cast<std::size_t>(
      std::max<Eigen::Index>(0, shown.rest->cols() - shown.original_vertices));
  legend_row(counted(flipped, "flipped edge", "flipped edges"), colours.flipped, true,
             context.look);
  legend_row(counted(split, "split vertex", "split vertices"), colours.split, false, context.look);
  dim_text(hovered ? words_of(*hovered, shown) : "Point at the mesh", context.look);
}

/// In the lower left corner of the pane, under what else is said there.
void draw_tools(Editor& editor, const std::function<void()>& draw_more,
                const PanelContext& context) {
  const bool are_poses = editor.view().beside() == Beside::kept_pose;
  const Look& look = context.look;
  const Rectangle& place = context.layout.side;
  ImGui::SetNextWindowPos({place.x + look.px(10), place.y + place.height - look.px(10)},
                          ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowBgAlpha(0.9F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look.px(6));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.palette->popup);
  if (ImGui::Begin("##side pane", nullptr,
                   ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                       ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing)) {
    draw_more();
    bool linked = editor.view().side_pane().is_linked();
    if (ImGui::Checkbox("Linked views", &linked)) editor.run_command("view.link_panes");
    tooltip("One magnification for both sides, moved together (Shift+D).", look);
    if (ImGui::Button("Close"))
      editor.run_command(are_poses ? "compare.side_by_side" : "view.remesh_diff");
    tooltip(are_poses ? "Back to one pose (Esc)." : "Back to the deformed mesh alone (D).", look);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

/// What both panes have: names and the line between them.
void draw_frame(const char* left, const char* right, const PanelContext& context) {
  const Layout& layout = context.layout;
  draw_name(left, layout.side, context.look);
  draw_name(right, layout.canvas, context.look);
  const float border = layout.side.x + layout.side.width + context.look.px(1);
  const float top = layout.menu_bar.y + layout.menu_bar.height;  // rulers are beside it too
  ImGui::GetBackgroundDrawList()->AddLine({border, top}, {border, layout.timeline.y},
                                          packed(context.look.palette->border), context.look.px(2));
}

/// What is pointed at in one is marked in the other.
void draw_remesh_panes(Editor& editor, const PaneInput& input, const PanelContext& context) {
  const Layout& layout = context.layout;
  const Snapshot& shown = *editor.shown();
  const Pane rest{layout.side, editor.view().side_pane().pane(), *shown.rest};
  const Pane deformed{layout.canvas, editor.canvas(), shown.deformed};
  std::optional<MeshPlace> hovered;
  if (input.pointer)
    hovered = place_at(*shown.triangles, rest.points, rest.canvas, *input.pointer);
  else if (context.state.pointer && !editor.draft().is_editing())
    hovered = place_at(*shown.triangles, deformed.points, deformed.canvas, *context.state.pointer);
  for (const Pane& pane : {rest, deformed})
    if (hovered) draw_highlight(*hovered, pane, context.look);
  draw_frame("Rest mesh", "Deformed mesh", context);
  draw_tools(
      editor, [&] { draw_legend(shown, hovered, context); }, context);
}

void draw_pose_panes(Editor& editor, const PanelContext& context) {
  draw_frame("A: kept pose", "B: this pose", context);
  const auto draw_keep = [&editor, &context] {
    if (ImGui::Button("Keep this pose as A")) editor.run_command("compare.keep");
    tooltip("What is at the right is then seen at the left too (Shift+\\).", context.look);
  };
  draw_tools(editor, draw_keep, context);
}

}  // namespace

void draw_side_panes(Editor& editor, const PanelContext& context) {
  const Beside beside = editor.view().beside();
  if (beside == Beside::nothing || !editor.shown()) return;
  const Canvas& pane = editor.view().side_pane().pane();
  const PaneInput input = view_pane("##side view", context.layout.side, pane);
  if (input.camera) editor.view().set_side_camera(*input.camera);
  if (beside == Beside::rest_mesh)
    draw_remesh_panes(editor, input, context);
  else
    draw_pose_panes(editor, context);
}

}  // namespace foldless
