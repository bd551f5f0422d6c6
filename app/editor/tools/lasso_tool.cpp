// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

class LassoTool final : public Tool {
 public:
  LassoTool(const Vec2& from, BandMode mode) : line_{from}, mode_(mode) {}

  std::vector<Vec2> lasso() const override { return line_; }
  std::string words() const override {
    return "Release to select · Shift adds · Ctrl takes away · Esc cancels";
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    if ((event.position - line_.back()).norm() < 1) return nullptr;
    line_.push_back(event.position);
    if (!before_) before_ = editor.selection().ids();
    const auto inside = handles_in_lasso(editor.shown().get(), editor.canvas(), line_);
    editor.selection().select(changed(*before_, inside, mode_));
    return nullptr;
  }

  std::unique_ptr<Tool> release(Editor&, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    return make_idle_tool();
  }

  void cancel(Editor& editor) override {
    if (before_) editor.selection().select(*before_);
  }

 private:
  std::vector<Vec2> line_;
  BandMode mode_;
  std::optional<std::set<int>> before_;  ///< the selection when it began
};

}  // namespace

std::unique_ptr<Tool> make_lasso_tool(const Vec2& from, BandMode mode) {
  return std::make_unique<LassoTool>(from, mode);
}

}  // namespace foldless
