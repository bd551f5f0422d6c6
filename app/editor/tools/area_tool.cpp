// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <set>
#include <vector>

#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

/// A selection after handles were surrounded. All are ids.
std::set<int> changed(const std::set<int>& selection, const std::vector<int>& inside,
                      BandMode mode) {
  std::set<int> result = mode == BandMode::replace ? std::set<int>{} : selection;
  for (const int id : inside) {
    if (mode == BandMode::subtract)
      result.erase(id);
    else
      result.insert(id);
  }
  return result;
}

/// Selects what a gesture surrounds, until the left button is released.
class AreaTool : public Tool {
 public:
  explicit AreaTool(BandMode mode) : mode_(mode) {}

  std::unique_ptr<Tool> release(Editor&, const PointerReleased& event) override {
    if (event.button != Button::left) return nullptr;
    return make_idle_tool();
  }

  void cancel(Editor& editor) override {
    if (before_) editor.selection().select(*before_);
  }

 protected:
  void surround(Editor& editor, const std::vector<int>& inside) {
    if (!before_) before_ = editor.selection().ids();
    editor.selection().select(changed(*before_, inside, mode_));
  }

 private:
  BandMode mode_;
  std::optional<std::set<int>> before_;  ///< the selection when it began
};

class BandTool final : public AreaTool {
 public:
  BandTool(const Vec2& from, BandMode mode) : AreaTool(mode), from_(from), to_(from) {}

  std::optional<PixelBox> band() const override {
    return PixelBox{from_.cwiseMin(to_), from_.cwiseMax(to_)};
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    to_ = event.position;
    surround(editor, handles_in(editor.shown().get(), editor.canvas(), *band()));
    return nullptr;
  }

 private:
  Vec2 from_;
  Vec2 to_;
};

class LassoTool final : public AreaTool {
 public:
  LassoTool(const Vec2& from, BandMode mode) : AreaTool(mode), line_{from} {}

  std::vector<Vec2> lasso() const override { return line_; }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    if ((event.position - line_.back()).norm() < 1) return nullptr;
    line_.push_back(event.position);
    surround(editor, handles_in_lasso(editor.shown().get(), editor.canvas(), line_));
    return nullptr;
  }

 private:
  std::vector<Vec2> line_;
};

}  // namespace

BandMode band_mode(const Modifiers& modifiers) {
  return modifiers.shift     ? BandMode::add
         : modifiers.control ? BandMode::subtract
                             : BandMode::replace;
}

std::unique_ptr<Tool> make_band_tool(const Vec2& from, BandMode mode) {
  return std::make_unique<BandTool>(from, mode);
}

std::unique_ptr<Tool> make_lasso_tool(const Vec2& from, BandMode mode) {
  return std::make_unique<LassoTool>(from, mode);
}

}  // namespace foldless
