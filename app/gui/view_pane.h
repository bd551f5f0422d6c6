// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/editor/canvas.h"
#include "app/gui/layout.h"

namespace foldless {

/// What the mouse did on a pane.
struct PaneInput {
  std::optional<Vec2> pointer;   ///< over the pane, in its pixels
  std::optional<Camera> camera;  ///< the new one, when it was moved
};

/// A part of the window through which a mesh is seen that was drawn under the panels: dragging with
/// any button moves it, the wheel zooms about the pointer.
PaneInput view_pane(const char* id, const Rectangle& place, const Canvas& canvas);

}  // namespace foldless
