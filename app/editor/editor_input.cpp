// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {
namespace {

constexpr double kZoomPerNotch = 1.15;
/// Space held longer than this was meant to pan, though nothing was dragged. [s]
constexpr double kTapSeconds = 0.4;

}  // namespace

void Editor::receive(const InputEvent& event, double now) {
  now_ = now;
  std::visit([this](const auto& e) { on(e); }, event);
}

void Editor::take_over(std::unique_ptr<Tool> next) {
  if (next) tool_ = std::move(next);
  redraw();
}

void Editor::on(const PointerPressed& event) {
  pointer_ = event.position;
  if (space_ && event.button == Button::left) space_->has_panned = true;
  take_over(tool_->press(*this, event));
}

void Editor::on(const PointerMoved& event) {
  pointer_ = event.position;
  const bool was_idle = tool_->is_idle();
  auto next = tool_->move(*this, event);
  if (!was_idle || next) take_over(std::move(next));
}

void Editor::on(const PointerReleased& event) {
  pointer_ = event.position;
  take_over(tool_->release(*this, event));
}

void Editor::on(const PointerLeft&) { set_hovered(std::nullopt); }

void Editor::on(const WheelTurned& event) {
  const double factor = std::pow(kZoomPerNotch, event.notches);
  set_camera(zoomed_about(canvas_.camera, canvas_.size(), {event.position.x(), event.position.y()},
                          factor));
}

void Editor::on(const KeyPressed& event) {
  if (event.key == Key::space && event.modifiers == Modifiers{}) {
    if (!event.is_repeat) space_ = SpaceKey{now_, false};
    return;
  }
  const Command* command = find_command(Shortcut{event.key, event.modifiers});
  if (!command || (event.is_repeat && !command->repeats)) return;
  if (command->release) {
    held_command_ = command;
    held_key_ = event.key;
  }
  run_command(command->name);
}

void Editor::on(const KeyReleased& event) {
  if (event.key == Key::space && space_) {
    const SpaceKey space = *std::exchange(space_, std::nullopt);
    if (!space.has_panned && now_ - space.since < kTapSeconds) run_command("solve.toggle");
  }
  if (held_command_ && event.key == held_key_) {
    std::exchange(held_command_, nullptr)->release(*this);
    redraw();
  }
}

void Editor::on(const FilesDropped& event) {
  if (!event.paths.empty()) drop(event.paths.front());
}

void Editor::on(const FocusLost&) {
  space_.reset();
  if (held_command_) std::exchange(held_command_, nullptr)->release(*this);
  for (const Button button : {Button::left, Button::right, Button::middle})
    on(PointerReleased{button, pointer_, {}});
  set_hovered(std::nullopt);
}

void Editor::cancel_gesture() {
  if (tool_->is_idle()) return;
  const auto tool = std::exchange(tool_, make_idle_tool());
  tool->cancel(*this);
  redraw();
}

}  // namespace foldless
