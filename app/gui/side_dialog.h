// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include "app/gui/layout.h"
#include "app/gui/panels.h"

namespace foldless {

/// Begins a modal dialog at the right that leaves the canvas to a preview; ImGui::EndPopup() must
/// follow when it returns true. Goes away when `is_open` is false.
bool begin_side_dialog(const char* id, bool is_open, const PanelContext& context);

/// What such a dialog leaves of the canvas.
Rectangle preview_place(const Layout& layout, float scale);

/// True in the frame in which a key went down that is not typed into a field. The key that opened
/// the dialog may still be down: its repeats do not count.
bool is_struck(ImGuiKey key);

}  // namespace foldless
