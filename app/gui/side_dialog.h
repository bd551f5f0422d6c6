// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include "app/gui/layout.h"
#include "app/gui/panels.h"

namespace foldless {

/// Begins a modal dialog at the right that leaves the canvas to a preview; end_side_dialog() must
/// follow when it returns true. Goes away when `is_open` is false.
bool begin_side_dialog(const char* id, bool is_open, const PanelContext& context);
void end_side_dialog();

/// What such a dialog leaves of the canvas.
Rectangle preview_place(const Layout& layout, float scale);

}  // namespace foldless
