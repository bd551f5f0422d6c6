// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels.h"
#include "app/gui/preview.h"

namespace foldless {

/// What lies on the canvas and is no mesh: selection band, distances to targets, the place of the
/// largest distortion.
void draw_canvas_overlay(Editor& editor, const PanelContext& context);

/// What is known of what a dialog offers, over its preview.
void draw_preview_overlay(const Preview& preview, const PanelContext& context);

}  // namespace foldless
