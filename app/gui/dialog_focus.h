// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/look.h"

namespace foldless {

// The keyboard in dialogs: Tab walks through the controls of the topmost one, Shift+Tab back, Space
// or Enter presses the one that has the focus. In the list of a combo box see choice_list.h. A ring
// shows the focus until the mouse is pressed. Dear ImGui 1.86 by itself walks text fields alone, so
// its navigation requests are made here.

/// Once a frame, before anything is drawn. Keys that the dialog captures do nothing here.
void follow_dialog_focus(bool captures_keys);

/// Draws the ring, over everything else.
void draw_dialog_focus(const Look& look);

/// From here on Tab stops at every control that is enabled; ended by end_tab_stops().
void begin_tab_stops();
void end_tab_stops();

/// In between: not at what follows, rows that arrows walk through; ended by end_list_rows().
void begin_list_rows();
void end_list_rows();

}  // namespace foldless
