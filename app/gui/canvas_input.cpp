// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/canvas_input.h"

#include <imgui.h>

#include <algorithm>

#include "app/gui/interface_commands.h"

namespace foldless {
namespace {

/// Keys belong to a dialog or a text field while there is one.
bool is_keyboard_taken() {
  return ImGui::GetIO().WantTextInput ||
         ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

}  // namespace

void CanvasInput::begin_frame(const Rectangle& canvas) { canvas_ = canvas; }

bool CanvasInput::is_on_canvas(const Vec2& position) const {
  return canvas_.contains(position.x(), position.y()) && !ImGui::GetIO().WantCaptureMouse;
}

bool CanvasInput::takes(const PointerPressed& event) {
  if (held_buttons_ == 0 && !is_on_canvas(event.position)) return false;
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

void CanvasInput::route(const InputEvent& event, Editor& editor, UiState& state, double time) {
  std::visit(
      [&](const auto& e) {
        using E = std::decay_t<decltype(e)>;
        if constexpr (requires { e.position; }) {
          if (!takes(e)) return held_buttons_ == 0 ? leave(editor, time) : void();
          E on_canvas = e;
          on_canvas.position -= Vec2(canvas_.x, canvas_.y);
          pointer_ = on_canvas.position;
          editor.receive(on_canvas, time);
        } else if constexpr (std::is_same_v<E, KeyPressed>) {
          if (is_keyboard_taken()) return;
          const auto command = editor.keys().command_of({e.key, e.modifiers});
          if (e.is_repeat || !run_interface_command(command, state)) editor.receive(e, time);
        } else {
          if constexpr (std::is_same_v<E, FocusLost>) held_buttons_ = 0;
          editor.receive(e, time);
        }
      },
      event);
  cursor_ = editor.selection().hovered() && pointer_ ? CursorShape::hand : CursorShape::arrow;
}

}  // namespace foldless
