// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/gui/look.h"
#include "render/distortion.h"

namespace foldless {

/// The colours of the heat map with numbers, as wide as the panel. `hovered` is the value under
/// the mouse on the canvas, marked on the scale.
void draw_heat_legend(const HeatRange& range, std::optional<double> hovered, const Look& look);

}  // namespace foldless
