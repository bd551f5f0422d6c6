// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/vector_pane.h"
#include "render/legend.h"

namespace foldless {

/// The bar of colours and its numbers, in strokes as in pictures: no font is needed.
void draw_legend(const VectorPane& pane, const Legend& legend);

}  // namespace foldless
