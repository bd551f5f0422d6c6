// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/mirroring.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

/// The end of an axis that a pixel is on.
Vec2 MirrorAxis::*end_near(const MirrorAxis& axis, const Canvas& canvas, const Vec2& pixel) {
  for (Vec2 MirrorAxis::*end : {&MirrorAxis::from, &MirrorAxis::to})
    if ((canvas.to_pixel(axis.*end) - pixel).norm() <= canvas.hit_radius()) return end;
  return nullptr;
}

/// Moves one end of the mirror's axis until the left button is released.
class AxisTool final : public Tool {
 public:
  explicit AxisTool(Vec2 MirrorAxis::*end) : end_(end) {}

  bool is_editing() const override { return true; }
  std::string words() const override {
    return "Release to set the mirror axis · Esc takes it back";
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    Document document = editor.document();
    MirrorAxis& axis = document.rig.mirror->axis;
    const Canvas& canvas = editor.canvas();
    axis.*end_ = canvas.to_world(event.position);
    // Ends that lie on each other make no axis.
    if ((canvas.to_pixel(axis.from) - canvas.to_pixel(axis.to)).norm() < canvas.hit_radius())
      return nullptr;
    editor.draft().apply(std::move(document), Change::appearance);
    has_moved_ = true;
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    if (has_moved_)
      editor.draft().commit("Move the mirror axis");
    else
      editor.draft().abandon_edit();
    return make_idle_tool();
  }

  void cancel(Editor& editor) override { editor.draft().abandon_edit(); }

 private:
  Vec2 MirrorAxis::*end_;
  bool has_moved_ = false;
};

}  // namespace

std::unique_ptr<Tool> begin_axis(Editor& editor, const Vec2& from) {
  if (!is_mirror_on(editor) || !editor.view().shown_options().layers.handles) return nullptr;
  const auto end = end_near(editor.document().rig.mirror->axis, editor.canvas(), from);
  if (!end) return nullptr;
  editor.draft().begin_edit();
  return std::make_unique<AxisTool>(end);
}

}  // namespace foldless
