// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/gui/panels.h"
#include "app/gui/plot.h"

namespace foldless {

/// Colour and line of a lane in heads, plots and table.
PlotCurve curve_of_lane(const Race& race, std::size_t lane, const Palette& palette);

/// A lane's title when those of all lanes have room, else what tells it from the others.
std::string lane_name(const Race& race, std::size_t lane, float width);

/// The line of a lane and what it runs, to be chosen anew, with room for a button behind it.
void draw_lane_choice(Editor& editor, std::size_t lane, const PanelContext& context);

/// Convergence of all lanes over each other, and their table.
void draw_race_results(Editor& editor, const PanelContext& context, const Rectangle& place);

}  // namespace foldless
