// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/editor/canvas.h"
#include "app/editor/tools/gestures.h"

namespace foldless {

/// The ring round the one handle that is selected: a drag from there turns it.
struct HandleRing {
  Vec2 centre = Vec2::Zero();  ///< pixels of the canvas
  double radius = 0;           ///< pixels
  double angle = 0;            ///< of the knob on it [degrees]
  /// How far the mesh follows, in pixels; nothing: the mesh is free to turn.
  std::optional<double> reach;

  bool is_near(const Vec2& pixel, const Canvas& canvas) const;
};

/// None while several handles are selected, none is, or handles are not drawn.
std::optional<HandleRing> handle_ring(const Editor& editor);

// Each changes the selected handles, which is one undo step. A number that is not finite is refused
// without a word, one out of range is clamped.

/// Whether the mesh round them turns with them. Those that begin to keep the angle that the mesh
/// has there now, and a radius beyond their neighbours.
void set_turning(Editor& editor, bool turns);
void set_angle(Editor& editor, double degrees);
void set_radius(Editor& editor, double radius);  ///< > 0 [length]

/// Begins to turn or scale with the pointer about the middle of the targets. One handle alone is
/// turned with the mesh round it, and cannot be scaled.
void begin_transformation(Editor& editor, Transformation what);
/// Begins to turn the one handle that is selected by its ring, with the left button.
std::unique_ptr<Tool> begin_ring(Editor& editor, const Vec2& from);

}  // namespace foldless
