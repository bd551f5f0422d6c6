// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels.h"
#include "app/gui/plot.h"

namespace foldless {

/// Colour and line of a lane in heads, plots and table.
PlotCurve curve_of_lane(const Race& race, std::size_t lane, const Palette& palette);

/// Convergence of all lanes over each other, and their table.
void draw_race_results(Editor& editor, const PanelContext& context, const Rectangle& place);

}  // namespace foldless
