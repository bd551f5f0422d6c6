// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/editor/editor.h"
#include "app/gui/look.h"

namespace foldless {

/// The magnification of the canvas in per cent, `150 %`.
std::string zoom_words(const Editor& editor);

/// How wide the button is in the current font. [pixels]
float zoom_button_width(const Editor& editor, const Look& look);

/// A button with the magnification, and a menu over it of others; it ends `right` pixels from the
/// left border of the current window.
void draw_zoom_menu(Editor& editor, float right, const Look& look);

}  // namespace foldless
