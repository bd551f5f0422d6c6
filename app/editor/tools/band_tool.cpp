// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/tools/gestures.h"

namespace foldless {
namespace {

class BandTool final : public Tool {
 public:
  BandTool(const Vec2& from, BandMode mode) : from_(from), to_(from), mode_(mode) {}

  std::optional<PixelBox> band() const override {
    return PixelBox{from_.cwiseMin(to_), from_.cwiseMax(to_)};
  }

  std::unique_ptr<Tool> move(Editor& editor, const PointerMoved& event) override {
    to_ = event.position;
    if (!before_) before_ = editor.selection().ids();
    std::set<int> selection = mode_ == BandMode::replace ? std::set<int>{} : *before_;
    for (const int id : handles_in(editor.shown().get(), editor.canvas(), *band())) {
      if (mode_ == BandMode::subtract)
        selection.erase(id);
      else
        selection.insert(id);
    }
    editor.selection().select(std::move(selection));
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
  Vec2 from_;
  Vec2 to_;
  BandMode mode_;
  std::optional<std::set<int>> before_;  ///< the selection when the band began
};

}  // namespace

std::unique_ptr<Tool> make_band_tool(const Vec2& from, BandMode mode) {
  return std::make_unique<BandTool>(from, mode);
}

}  // namespace foldless
