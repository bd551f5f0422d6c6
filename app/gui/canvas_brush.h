// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <imgui.h>

#include <string>

#include "app/gui/panels.h"

namespace foldless {

/// Draws on the canvas, under all panels, in its pixels.
struct CanvasBrush {
  ImDrawList& list;
  const Rectangle& canvas;

  ImVec2 at(const Vec2& pixel) const {
    return {canvas.x + static_cast<float>(pixel.x()), canvas.y + static_cast<float>(pixel.y())};
  }
};

/// Text on a plate of its own, readable over a checkerboard; `middle` is its centre in the window.
void draw_plate(const std::string& words, const ImVec2& middle, const CanvasBrush& brush,
                const Look& look);

/// The outlines of other poses.
void draw_outlines(const Editor& editor, const CanvasBrush& brush, const Look& look);

/// The bones between the joints of the mesh on screen, and the one that a click would add.
void draw_bones(const Editor& editor, const CanvasBrush& brush, const PanelContext& context);

/// The mirror's axis while it is on, with ends that can be dragged.
void draw_mirror(const Editor& editor, const CanvasBrush& brush, const Look& look);

/// The centres of swings, with grips that are pulled.
void draw_swings(const Editor& editor, const CanvasBrush& brush, const Look& look);

/// The ring that turns the selected handle, and the name of the one under the pointer.
void draw_handle_notes(Editor& editor, const CanvasBrush& brush, const PanelContext& context);

}  // namespace foldless
