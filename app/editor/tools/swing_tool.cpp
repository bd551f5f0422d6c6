// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/swing_centre.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

constexpr double kGripDistance = 3;  ///< of the hit radius

/// Moves the centre of a swing until the left button is released.
class SwingTool final : public Tool {
 public:
  SwingTool(std::size_t group, Vec2 offset) : group_(group), offset_(std::move(offset)) {}

  bool is_editing() const override { return true; }
  std::string words() const override {
    return "Release to set the centre of the swing · Esc takes it back";
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    Document document = editor.document();
    Animation animation = *document.animation;
    animation.groups[group_].center = editor.canvas().to_world(event.position + offset_);
    document.animation = std::make_shared<const Animation>(std::move(animation));
    editor.draft().apply(std::move(document), Change::appearance);
    has_moved_ = true;
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor& editor, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    if (has_moved_)
      editor.draft().commit("Move the centre of a swing");
    else
      editor.draft().abandon_edit();
    return make_idle_tool();
  }

  void cancel(Editor& editor) override { editor.draft().abandon_edit(); }

 private:
  std::size_t group_;
  Vec2 offset_;  ///< from the pointer to the centre [pixels]
  bool has_moved_ = false;
};

}  // namespace

std::vector<std::size_t> shown_swings(const Editor& editor) {
  std::vector<std::size_t> shown;
  if (!editor.motion().is_open() || !editor.view().shown_options().layers.handles) return shown;
  const auto& selected = editor.selection().ids();
  const std::vector<TurningGroup>& groups = editor.motion().animation().groups;
  for (std::size_t i = 0; i < groups.size(); ++i)
    if (selected.empty() ||
        std::ranges::any_of(groups[i].handles, [&](int id) { return selected.contains(id); }))
      shown.push_back(i);
  return shown;
}

Vec2 swing_grip(const Canvas& canvas, const Vec2& centre) {
  return canvas.to_pixel(centre) + Vec2(0, kGripDistance * canvas.hit_radius());
}

std::optional<std::size_t> swing_at(const Editor& editor, const Vec2& pixel) {
  const Canvas& canvas = editor.canvas();
  const std::vector<TurningGroup>& groups = editor.motion().animation().groups;
  for (const std::size_t i : shown_swings(editor))
    if ((swing_grip(canvas, groups[i].center) - pixel).norm() <= canvas.hit_radius()) return i;
  return std::nullopt;
}

std::unique_ptr<Tool> begin_swing(Editor& editor, const Vec2& from) {
  const auto group = swing_at(editor, from);
  if (!group) return nullptr;
  const Vec2 centre = editor.motion().animation().groups[*group].center;
  const Vec2 offset = editor.canvas().to_pixel(centre) - from;
  editor.draft().begin_edit();
  return std::make_unique<SwingTool>(*group, offset);
}

}  // namespace foldless
