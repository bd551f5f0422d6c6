// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/panels.h"
#include "app/gui/thumbnails.h"

namespace foldless {

/// What there is while nothing is open: a place to drop a file, recent files and samples as
/// pictures.
void draw_start_screen(Editor& editor, Thumbnails& thumbnails, const PanelContext& context);

}  // namespace foldless
