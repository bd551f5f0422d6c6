// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>

#include "app/gui/choice_list.h"
#include "app/gui/heat_legend.h"
#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

void draw_layer_row(std::size_t index, Layers& layers, const Look& look) {
  const LayerRow& row = kLayerRows[index];
  ImGui::Checkbox(row.title.data(), &(layers.*row.shown));
  const std::string key = std::to_string(index + 1);
  std::string tip = "Key ";
  tip.append(key).append(" switches this layer. Hold H to hide all that lies over the mesh.");
  tooltip(tip, look);
  const float width = ImGui::CalcTextSize(key.c_str()).x;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width - look.px(2));
  ImGui::AlignTextToFramePadding();
  ImGui::TextColored(look.palette->dim, "%s", key.c_str());
}

void draw_heat_controls(ViewOptions& view, const PanelContext& context) {
  static constexpr std::array kMeasures{"Conformal σ₁/σ₂", "Area A′/A", "Energy density ψ"};
  ImGui::SetNextItemWidth(-1);
  const auto present = static_cast<std::size_t>(view.heat_measure);
  if (begin_combo("##measure", kMeasures[present])) {
    for (std::size_t i = 0; i < kMeasures.size(); ++i)
      if (choice_entry(kMeasures[i], i == present)) view.heat_measure = static_cast<HeatMeasure>(i);
    ImGui::EndCombo();
  }
  tooltip("What the heat map shows of each triangle.", context.look);
  if (context.state.heat_range)
    draw_heat_legend(*context.state.heat_range, context.state.hovered_heat, context.look);
}

void draw_checker_slider(ViewOptions& view, const Look& look) {
  auto squares = static_cast<float>(view.checker_squares);
  constexpr float kFewest = 2, kMost = 128;
  ImGui::SetNextItemWidth(-1);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImVec4{0, 0, 0, 0});
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, ImVec4{0, 0, 0, 0});
  if (ImGui::SliderFloat("##checker", &squares, kFewest, kMost, "%.0f checker squares",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
    view.checker_squares = squares;
  ImGui::PopStyleColor(2);
  slider_line(std::log(squares / kFewest) / std::log(kMost / kFewest), look);
  tooltip("Squares along the longer side of the mesh at rest. Ctrl-click to type a number.", look);
}

}  // namespace

void draw_layers_panel(Editor& editor, const PanelContext& context) {
  ViewOptions& view = editor.view().options();
  const ViewOptions before = view;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{context.look.px(4), context.look.px(1)});
  for (std::size_t i = 0; i < kLayerRows.size(); ++i) draw_layer_row(i, view.layers, context.look);
  ImGui::PopStyleVar();
  if (view.layers.heat) draw_heat_controls(view, context);
  if (view.layers.fill && editor.document().texture.empty())
    draw_checker_slider(view, context.look);
  if (!editor.document().texture.empty() && ImGui::Button("Back to the checkerboard", {-1, 0}))
    editor.files().clear_texture();
  if (!(view == before)) editor.messages().redraw();
}

}  // namespace foldless
