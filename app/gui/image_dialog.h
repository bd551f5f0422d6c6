// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels.h"

namespace foldless {

/// How an image becomes a mesh, at the right of its preview. Enter takes it, Esc leaves everything
/// as it was.
void draw_image_dialog(Editor& editor, const PanelContext& context);

}  // namespace foldless
