// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor_input.h"

#include <cmath>
#include <utility>

#include "app/editor/editor.h"

namespace foldless {
namespace {

constexpr double kZoomPerNotch = 1.15;
/// Space held longer than this was meant to pan, though nothing was dragged. [s]
constexpr double kTapSeconds = 0.4;

}  // namespace

EditorInput::EditorInput(Editor& editor) : editor_(editor), tool_(make_idle_tool()) {}

void EditorInput::receive(const InputEvent& event) {
  std::visit([this](const auto& e) { on(e); }, event);
}

void EditorInput::take_over(std::unique_ptr<Tool> next) {
  if (next) tool_ = std::move(next);
  editor_.messages().redraw();
}

void EditorInput::on(const PointerPressed& event) {
  pointer_ = event.position;
  if (space_ && event.button == Button::left) space_->has_panned = true;
  take_over(tool_->press(editor_, event));
}

void EditorInput::on(const PointerMoved& event) {
  pointer_ = event.position;
  const bool was_idle = tool_->is_idle();
  auto next = tool_->move(editor_, event);
  if (!was_idle || next) take_over(std::move(next));
}

void EditorInput::on(const PointerReleased& event) {
  pointer_ = event.position;
  take_over(tool_->release(editor_, event));
}

void EditorInput::on(const PointerLeft&) { editor_.draft().selection().hover(std::nullopt); }

void EditorInput::on(const WheelTurned& event) {
  const double factor = std::pow(kZoomPerNotch, event.notches);
  const Canvas& canvas = editor_.canvas();
  const glm::dvec2 at{event.position.x(), event.position.y()};
  editor_.view().set_camera(zoomed_about(canvas.camera, canvas.size(), at, factor));
}

void EditorInput::on(const KeyPressed& event) {
  if (event.key == Key::space && event.modifiers == Modifiers{}) {
    if (!event.is_repeat) space_ = SpaceKey{editor_.messages().now(), false};
    return;
  }
  if (event.key == Key::l && event.modifiers == Modifiers{}) is_lasso_held_ = true;
  std::unique_ptr<Tool> next;
  if (tool_->key(editor_, event, next)) return take_over(std::move(next));
  modifiers_ = event.modifiers;
  const Command* command = find_command(editor_.keys().command_of({event.key, event.modifiers}));
  if (!command || (event.is_repeat && !command->repeats)) return;
  if (command->release) {
    held_command_ = command;
    held_key_ = event.key;
  }
  editor_.run_command(command->name);
}

void EditorInput::on(const KeyReleased& event) {
  if (event.key == Key::l) is_lasso_held_ = false;
  modifiers_ = {};
  if (event.key == Key::space && space_) {
    const SpaceKey space = *std::exchange(space_, std::nullopt);
    if (!space.has_panned && editor_.messages().now() - space.since < kTapSeconds)
      editor_.run_command("solve.toggle");
  }
  if (held_command_ && event.key == held_key_) {
    std::exchange(held_command_, nullptr)->release(editor_);
    editor_.messages().redraw();
  }
}

void EditorInput::on(const FilesDropped& event) { editor_.files().drop(event.paths); }

void EditorInput::on(const FocusLost&) {
  space_.reset();
  is_lasso_held_ = false;
  if (held_command_) std::exchange(held_command_, nullptr)->release(editor_);
  for (const Button button : {Button::left, Button::right, Button::middle})
    on(PointerReleased{button, pointer_, {}});
  editor_.draft().selection().hover(std::nullopt);
}

void EditorInput::begin(std::unique_ptr<Tool> tool) { take_over(std::move(tool)); }

bool EditorInput::cancel_gesture() {
  if (is_idle()) return false;
  const auto tool = std::exchange(tool_, make_idle_tool());
  tool->cancel(editor_);
  editor_.messages().redraw();
  return true;
}

}  // namespace foldless
