// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>

#include "app/editor/convergence.h"
#include "app/gui/panels.h"
#include "app/gui/plot.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// Which curves are drawn, and where they are written to.
void draw_controls(Editor& editor, const PanelContext& context) {
  const auto series = convergence_series();
  auto& shown = context.state.shown_series;
  if (ImGui::Button("Curves…")) ImGui::OpenPopup("##curves");
  tooltip(
      "Which quantities are plotted, and over what. On a plot Ctrl and the wheel zoom, a double "
      "click "
      "shows all.",
      context.look);
  if (ImGui::BeginPopup("##curves")) {
    for (std::size_t i = 0; i < series.size(); ++i)
      ImGui::Checkbox(series[i].title.data(), &shown[i]);
    ImGui::Separator();
    ImGui::Checkbox("Over processor time", &context.state.has_time_axis);
    ImGui::EndPopup();
  }
  ImGui::BeginDisabled(editor.playback().iterations().empty());
  ImGui::SameLine();
  if (ImGui::Button("CSV…")) editor.run_command("file.export_csv");
  tooltip("Writes every iteration with all its numbers to a file.", context.look);
  ImGui::SameLine();
  if (ImGui::Button("SVG…")) editor.run_command("file.export_svg");
  tooltip("Draws these curves into a file, as the paper's Figure 13.", context.look);
  ImGui::EndDisabled();
}

}  // namespace

void draw_plots_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const auto series = convergence_series();
  draw_controls(editor, context);
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!context.state.shown_series[i]) continue;
    const auto& iterations = editor.playback().iterations();
    std::array curves{PlotCurve{std::string(series[i].title),
                                values_of(series[i], iterations, iterations.size()),
                                look.palette->series[i % look.palette->series.size()]}};
    if (context.state.has_time_axis) curves[0].positions = times_of(iterations, iterations.size());
    const auto chosen = draw_plot({.id = series[i].name.data(),
                                   .title = series[i].title.data(),
                                   .curves = curves,
                                   .is_logarithmic = series[i].is_logarithmic,
                                   .cursor = editor.playback().scrubbed(),
                                   .size = {ImGui::GetContentRegionAvail().x, look.px(86)},
                                   .font = look.fonts.small,
                                   .zoom = &context.state.plot_zoom,
                                   .unit = context.state.has_time_axis ? " s" : ""},
                                  *look.palette);
    if (chosen && editor.playback().can_scrub()) editor.playback().scrub(*chosen);
  }
}

}  // namespace foldless
