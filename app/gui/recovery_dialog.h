// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels.h"

namespace foldless {

/// Offers work that was lost when the program ended without being asked to; the one that is looked
/// at is on the canvas beside the dialog.
void draw_recovery_dialog(Editor& editor, const PanelContext& context);

}  // namespace foldless
