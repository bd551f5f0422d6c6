// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

class PanTool final : public Tool {
 public:
  PanTool(const Vec2& from, Button button)
      : from_(from), last_(from), button_(button), is_click_(button == Button::right) {}

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    if (is_click_ && (event.position - from_).norm() <= editor.canvas().drag_threshold())
      return nullptr;
    is_click_ = false;
    const Vec2 by = event.position - last_;
    last_ = event.position;
    editor.view().set_camera(panned(editor.canvas().camera, {by.x(), by.y()}));
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor&, const PointerReleased& event) override {
    if (event.button != button_) return nullptr;
    return make_idle_tool();
  }

 private:
  Vec2 from_;
  Vec2 last_;
  Button button_;
  bool is_click_;  ///< of the right button, so far: it opens a menu and does not pan
};

}  // namespace

std::unique_ptr<Tool> make_pan_tool(const Vec2& from, Button button) {
  return std::make_unique<PanTool>(from, button);
}

}  // namespace foldless
