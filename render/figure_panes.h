// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/snapshot.h"
#include "render/camera.h"
#include "render/figure_options.h"
#include "render/viewport.h"

namespace foldless {

/// A part of a figure: where, from where, and how one of the two meshes is drawn.
struct FigurePane {
  Viewport viewport;
  Camera camera;
  ViewOptions style;  ///< its background is kept
  bool is_miniature = false;
};

/// From left to right, then the miniature. They leave room for the legend of a heat map.
std::vector<FigurePane> figure_panes(const Snapshot& snapshot, const FigureOptions& options);

/// The box of the deformed mesh, the rest mesh, or both, with the targets of the handles.
Box frame_of(const Snapshot& snapshot, FigureView view);

}  // namespace foldless
