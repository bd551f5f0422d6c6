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
  tooltip("Which quantities are plotted over the iterations.", context.look);
  if (ImGui::BeginPopup("##curves")) {
    for (std::size_t i = 0; i < series.size(); ++i)
      ImGui::Checkbox(series[i].title.data(), &shown[i]);
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
    const std::array curves{PlotCurve{
        std::string(series[i].title),
        values_of(series[i], editor.playback().iterations(), editor.playback().iterations().size()),
        look.palette->series[i % look.palette->series.size()]}};
    const auto chosen = draw_plot({series[i].name.data(),
                                   series[i].title.data(),
                                   curves,
                                   series[i].is_logarithmic,
                                   editor.playback().scrubbed(),
                                   {ImGui::GetContentRegionAvail().x, look.px(72)},
                                   look.fonts.small},
                                  *look.palette);
    if (chosen && editor.playback().can_scrub()) editor.playback().scrub(*chosen);
  }
}

}  // namespace foldless
