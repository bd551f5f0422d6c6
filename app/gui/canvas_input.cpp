// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/canvas_input.h"

#include <imgui.h>

#include <algorithm>

#include "app/gui/interface_commands.h"

namespace foldless {
namespace {

bool is_popup_open() {
  return ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

/// Keys belong to a dialog or a text field while there is one.
bool is_keyboard_taken() { return ImGui::GetIO().WantTextInput || is_popup_open(); }

}  // namespace

void CanvasInput::begin_frame(const Rectangle& canvas) { canvas_ = canvas; }

bool CanvasInput::is_on_canvas(const Vec2& position) const {
  return canvas_.contains(position.x(), position.y()) && !ImGui::GetIO().WantCaptureMouse;
}

bool CanvasInput::takes(const PointerPressed& event) {
  // A press beside an open menu closes that, and does no more.
  if (held_buttons_ == 0 && (!is_on_canvas(event.position) || is_popup_open())) return false;
  ++held_buttons_;
  return true;
}

bool CanvasInput::takes(const PointerMoved& event) {
  return held_buttons_ > 0 || is_on_canvas(event.position);
}

bool CanvasInput::takes(const PointerReleased&) {
  if (held_buttons_ == 0) return false;
  --held_buttons_;
  return true;
}

bool CanvasInput::takes(const WheelTurned& event) { return is_on_canvas(event.position); }

void CanvasInput::leave(Editor& editor, double time) {
  if (pointer_) editor.receive(PointerLeft{}, time);
  pointer_.reset();
}

/// A click of it, which drags nothing, asks for the menu.
void CanvasInput::follow_right_button(const InputEvent& event, Editor& editor, UiState& state) {
  if (const auto* press = std::get_if<PointerPressed>(&event)) {
    right_press_.reset();
    if (press->button == Button::right && editor.input().is_idle()) right_press_ = press->position;
  } else if (const auto* move = std::get_if<PointerMoved>(&event)) {
    const double dragged = right_press_ ? (move->position - *right_press_).norm() : 0;
    if (dragged > editor.canvas().drag_threshold()) right_press_.reset();
  } else if (const auto* release = std::get_if<PointerReleased>(&event)) {
    if (release->button != Button::right || !right_press_) return;
    right_press_.reset();
    if (!editor.document().is_empty()) state.context_menu.open(editor);
  }
}

void CanvasInput::route(const InputEvent& event, Editor& editor, UiState& state, double time) {
  std::visit(
      [&](const auto& e) {
        using E = std::decay_t<decltype(e)>;
        if constexpr (requires { e.position; }) {
          if (!takes(e)) return held_buttons_ == 0 ? leave(editor, time) : void();
          E on_canvas = e;
          on_canvas.position -= Vec2(canvas_.x, canvas_.y);
          pointer_ = on_canvas.position;
          follow_right_button(on_canvas, editor, state);
          editor.receive(on_canvas, time);
        } else if constexpr (std::is_same_v<E, KeyPressed>) {
          if (is_keyboard_taken()) return;
          const auto command = editor.keys().command_of({e.key, e.modifiers});
          if (e.is_repeat || !run_interface_command(command, state)) editor.receive(e, time);
        } else {
          if constexpr (std::is_same_v<E, FocusLost>) held_buttons_ = 0, right_press_.reset();
          editor.receive(e, time);
        }
      },
      event);
  cursor_ = editor.selection().hovered() && pointer_ ? CursorShape::hand : CursorShape::arrow;
}

}  // namespace foldless
