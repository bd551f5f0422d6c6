// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

constexpr double kSizeStep = 1.25;

class IdleTool final : public Tool {
 public:
  bool is_idle() const override { return true; }

  std::unique_ptr<Tool> press(Editor& editor, const PointerPressed& event) override {
    if (event.button != Button::left || editor.input().is_space_held())
      return make_pan_tool(event.position, event.button);
    if (editor.input().is_lasso_held())
      return make_lasso_tool(event.position, band_mode(event.modifiers));
    if (editor.brush().is_on()) return begin_painting(editor, event);
    if (editor.bone_tool().is_on()) {
      editor.bone_tool().click(editor, event.position);
      return nullptr;
    }
    const Snapshot* shown = editor.shown().get();
    if (const auto hit = pick_handle(shown, editor.canvas(), event.position)) {
      const bool is_selected = editor.selection().ids().contains(hit->id);
      if (!is_selected && !event.modifiers.shift && !event.modifiers.control)
        editor.selection().select({hit->id});
      return make_press_tool(event, hit, true);
    }
    if (auto axis = begin_axis(editor, event.position)) return axis;
    if (auto swing = begin_swing(editor, event.position)) return swing;
    const bool is_on_mesh =
        pick_mesh(shown, editor.canvas(), event.position, editor.draft().paint_order()).has_value();
    return make_press_tool(event, std::nullopt, is_on_mesh);
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    if (editor.brush().is_on()) {
      editor.selection().hover(std::nullopt);
      editor.messages().redraw();  // the brush follows the pointer
      return nullptr;
    }
    const auto hit = pick_handle(editor.shown().get(), editor.canvas(), event.position);
    editor.selection().hover(hit ? std::optional(hit->id) : std::nullopt);
    return nullptr;
  }

  /// Brackets change the size of the brush that is in the hand, not depths; Enter ends bones.
  bool key(Editor& editor, const KeyPressed& event, std::unique_ptr<Tool>&) override {
    if (event.key == Key::enter && !editor.bone_tool().chain().empty()) {
      editor.bone_tool().end_chain();
      return true;
    }
    const bool grows = event.key == Key::right_bracket;
    if (!editor.brush().is_on() || !(event.modifiers == Modifiers{})) return false;
    if (!grows && event.key != Key::left_bracket) return false;
    editor.brush().set_radius(editor.brush().radius() * (grows ? kSizeStep : 1 / kSizeStep));
    return true;
  }
};

}  // namespace

std::unique_ptr<Tool> make_idle_tool() { return std::make_unique<IdleTool>(); }

}  // namespace foldless
