// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

/// Moves the stiffness brush until the left button is released.
class PaintTool final : public Tool {
 public:
  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    editor.brush().move(editor.canvas(), event.position);
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    editor.brush().release();
    return make_idle_tool();
  }

  void cancel(Editor& editor) override { editor.brush().cancel(); }
};

}  // namespace

std::unique_ptr<Tool> begin_painting(Editor& editor, const PointerPressed& event) {
  editor.brush().press(editor.canvas(), event.position, event.modifiers.shift);
  return std::make_unique<PaintTool>();
}

}  // namespace foldless
