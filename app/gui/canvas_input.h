// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/editor/editor.h"
#include "app/gui/extent.h"
#include "app/gui/layout.h"
#include "app/gui/ui_state.h"

namespace foldless {

/// Decides which events are the canvas's and hands them to the editor. Lives inside an ImGui frame.
class CanvasInput {
 public:
  void begin_frame(const Rectangle& canvas);
  /// Position in framebuffer pixels of the whole window.
  /// Keys of the interface change its state.
  void route(const InputEvent& event, Editor& editor, UiState& state, double time);

  /// Where the pointer is on the canvas in its pixels; nothing while it is elsewhere.
  std::optional<Vec2> pointer() const { return pointer_; }
  CursorShape cursor() const { return cursor_; }

 private:
  bool is_on_canvas(const Vec2& position) const;
  bool takes(const PointerPressed& event);
  bool takes(const PointerMoved& event);
  bool takes(const PointerReleased& event);
  bool takes(const WheelTurned& event);
  void leave(Editor& editor, double time);
  void follow_right_button(const InputEvent& event, Editor& editor, UiState& state);

  Rectangle canvas_;
  /// Where the right button went down on the canvas while nothing else was done, until it is
  /// dragged.
  std::optional<Vec2> right_press_;
  int held_buttons_ = 0;  ///< pressed on the canvas and not yet let go
  std::optional<Vec2> pointer_;
  CursorShape cursor_ = CursorShape::arrow;
};

}  // namespace foldless
