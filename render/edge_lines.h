// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/line_style.h"
#include "render/mesh_sheets.h"
#include "render/view_options.h"

namespace foldless {

/// Edges of a mesh and how they are drawn.
struct EdgeLines {
  EdgeSet set;
  LineStyle style;
};

/// What the layers draw over the inside of a sheet, from back to front.
std::vector<EdgeLines> edge_lines(const ViewOptions& options);

/// The outline of the rest mesh behind the deformed one.
LineStyle rest_outline(const ViewOptions& options);

}  // namespace foldless
