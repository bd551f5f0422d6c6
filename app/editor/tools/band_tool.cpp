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
    const auto inside = handles_in(editor.shown().get(), editor.canvas(), *band());
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
  Vec2 from_;
  Vec2 to_;
  BandMode mode_;
  std::optional<std::set<int>> before_;  ///< the selection when the band began
};

}  // namespace

BandMode band_mode(const Modifiers& modifiers) {
  return modifiers.shift     ? BandMode::add
         : modifiers.control ? BandMode::subtract
                             : BandMode::replace;
}

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

std::unique_ptr<Tool> make_band_tool(const Vec2& from, BandMode mode) {
  return std::make_unique<BandTool>(from, mode);
}

}  // namespace foldless
