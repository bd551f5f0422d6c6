// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/editor/edits.h"
#include "app/editor/tool.h"

namespace foldless {

/// A button is down and the pointer has not yet moved beyond the drag threshold: a click, or the
/// beginning of a drag.
std::unique_ptr<Tool> make_press_tool(const PointerPressed& event,
                                      const std::optional<HandleHit>& handle, bool is_on_mesh);

/// Puts a handle there, another at its mirror image, and selects the first, between begin_edit()
/// and commit(). Returns whether the document changed.
bool place_at(Editor& editor, const MeshHit& hit);

/// What a drag of handles begins with.
struct HandleDrag {
  Vec2 from = Vec2::Zero();    ///< where the button went down [world]
  std::vector<Target> starts;  ///< targets when it did
  std::string label;           ///< of the undo step
  Document before;             ///< as it was then
};

/// Moves targets with the pointer until the left button is released. Precondition: begin_edit().
std::unique_ptr<Tool> make_drag_tool(HandleDrag drag);

/// How a rectangle changes the selection.
enum class BandMode { replace, add, subtract };

BandMode band_mode(const Modifiers& modifiers);

/// Spans a rectangle from a pixel until the left button is released.
std::unique_ptr<Tool> make_band_tool(const Vec2& from, BandMode mode);

/// Draws a line round handles until the left button is released.
std::unique_ptr<Tool> make_lasso_tool(const Vec2& from, BandMode mode);

/// What a transformation of the selected handles does about the middle of their targets.
enum class Transformation { turn, scale };

/// Turns or scales with the pointer, without a button, until a click or Enter takes it or Esc or
/// another button takes it back; a number may be typed instead. Precondition: begin_edit().
std::unique_ptr<Tool> make_transform_tool(Transformation what, const Vec2& from,
                                          std::vector<Target> starts);

/// The same turn of one handle by its ring, while the left button is down.
std::unique_ptr<Tool> make_ring_tool(const Vec2& from, std::vector<Target> starts);

/// Paints with the stiffness brush until the left button is released; with Shift it takes back.
std::unique_ptr<Tool> begin_painting(Editor& editor, const PointerPressed& event);

/// Moves an end of the mirror's axis until the left button is released; null where none is.
std::unique_ptr<Tool> begin_axis(Editor& editor, const Vec2& from);

/// Moves the centre of a swing by its grip until the left button is released; null where none is.
std::unique_ptr<Tool> begin_swing(Editor& editor, const Vec2& from);

/// Moves the view until the button is released.
std::unique_ptr<Tool> make_pan_tool(const Vec2& from, Button button);

}  // namespace foldless
