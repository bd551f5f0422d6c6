// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "app/gui/panels.h"
#include "app/gui/plot.h"
#include "app/gui/widgets.h"

namespace foldless {
namespace {

/// One curve over the iterations.
struct Series {
  const char* id;
  const char* title;
  double Iteration::*value;
};

constexpr std::array<Series, 3> kSeries{{
    {"energy", "Energy E", &Iteration::energy},
    {"gradient", "Gradient ‖∇E‖²", &Iteration::gradient_norm_squared},
    {"residual", "Distance to targets ‖P‖²", &Iteration::handle_error_squared},
}};

}  // namespace

void draw_plots_panel(Editor& editor, const PanelContext& context) {
  const Look& look = context.look;
  const auto& iterations = editor.iterations();
  std::vector<double> values(iterations.size());
  for (std::size_t i = 0; i < kSeries.size(); ++i) {
    for (std::size_t n = 0; n < iterations.size(); ++n) values[n] = iterations[n].*kSeries[i].value;
    const Plot plot{
        kSeries[i].id,           kSeries[i].title,  values,
        look.palette->series[i], editor.scrubbed(), {ImGui::GetContentRegionAvail().x, look.px(72)},
        look.fonts.small};
    const auto chosen = draw_log_plot(plot, *look.palette);
    if (chosen && editor.can_scrub()) editor.scrub(*chosen);
  }
}

}  // namespace foldless
