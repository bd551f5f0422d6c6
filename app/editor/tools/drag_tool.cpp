// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/mirroring.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

class DragTool final : public Tool {
 public:
  explicit DragTool(HandleDrag drag) : drag_(std::move(drag)) {}

  bool is_editing() const override { return true; }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    const Vec2 by = editor.canvas().to_world(event.position) - drag_.from;
    std::vector<Target> targets = drag_.starts;
    for (Target& target : targets) target.position += by;
    targets = with_rig(editor, drag_.before, std::move(targets));
    editor.draft().apply(with_targets(editor.document(), targets), Change::targets);
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    editor.draft().commit(drag_.label);
    return make_idle_tool();
  }

  void cancel(Editor& editor) override { editor.draft().abandon_edit(); }

 private:
  HandleDrag drag_;
};

}  // namespace

std::unique_ptr<Tool> make_drag_tool(HandleDrag drag) {
  return std::make_unique<DragTool>(std::move(drag));
}

}  // namespace foldless
