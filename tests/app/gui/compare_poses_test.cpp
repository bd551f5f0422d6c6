// SPDX-License-Identifier: GPL-3.0-or-later
// What is compared on the canvas, and the log of messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class ComparePoses : public testing::Test {
 protected:
  ComparePoses() {
    editor().files().open_shape(grid({.columns = 12, .rows = 4, .width = 6}), "strip");
    headless_.calm_down();
    headless_.click(headless_.window_point(editor().shown()->deformed.col(0)));
    const Vec2 from = headless_.window_point(editor().shown()->deformed.col(64));
    headless_.press(from);
    headless_.move(from + Vec2(-60, 40));
    headless_.release(from + Vec2(-60, 40));
    headless_.wait_until([this] { return !editor().playback().is_solving(); });
    headless_.calm_down();
  }
  Editor& editor() { return headless_.editor(); }

  std::string clipboard_;
  HeadlessEditor headless_{
      {1280, 800}, {.set_clipboard = [this](const std::string& text) { clipboard_ = text; }}};
};

TEST_F(ComparePoses, TheRestShapeIsSeenAsLongAsTheKeyIsHeld) {
  const Image posed = headless_.picture();
  editor().run_command("compare.hold");
  headless_.settle();
  const Image at_rest = headless_.picture();
  EXPECT_GT(differing_pixels(posed, at_rest), 3000);
  editor().comparison().hold(false);
  headless_.settle();
  EXPECT_EQ(differing_pixels(posed, headless_.picture()), 0);
}

TEST_F(ComparePoses, OutlinesAreDrawn) {
  const Image before = headless_.picture();
  headless_.key(Key::o);
  headless_.settle();
  EXPECT_GT(differing_pixels(before, headless_.picture()), 500);
  editor().view().hide_overlays(true);
  headless_.settle();
  const Image hidden = headless_.canvas_picture();
  editor().comparison().clear_outlines();
  headless_.settle();
  EXPECT_EQ(differing_pixels(hidden, headless_.canvas_picture()), 0) << "H hides them";
  editor().view().hide_overlays(false);
  headless_.settle();
  EXPECT_EQ(differing_pixels(before, headless_.picture()), 0);
}

TEST_F(ComparePoses, TheHeatMapShowsAnglesAreasOrTheEnergy) {
  ViewOptions& options = editor().view().options();
  options.layers.heat = true;
  std::vector<Image> pictures;
  for (const HeatMeasure measure :
       {HeatMeasure::conformal, HeatMeasure::area, HeatMeasure::energy}) {
    options.heat_measure = measure;
    headless_.settle();
    pictures.push_back(headless_.canvas_picture());
  }
  EXPECT_GT(differing_pixels(pictures[0], pictures[1]), 3000);
  EXPECT_GT(differing_pixels(pictures[0], pictures[2]), 3000);
  EXPECT_GT(differing_pixels(pictures[1], pictures[2]), 3000);
  // A kept pose is drawn by its own triangles.
  editor().run_command("compare.keep");
  editor().run_command("compare.hold");
  headless_.settle();
  EXPECT_LT(differing_pixels(pictures[2], headless_.canvas_picture()), 20000)
      << "but for the plate";
  EXPECT_GT(differing_pixels(pictures[0], headless_.canvas_picture()), 3000);
  editor().comparison().hold(false);
  // Of an undeformed mesh the energy is zero everywhere: one colour, no scale to divide by.
  editor().edits().reset_pose();
  headless_.calm_down();
  const Vec2 a = headless_.window_point({1, 0.1}), b = headless_.window_point({5, 0.8});
  const Image at_rest = headless_.picture();
  const auto pixel = [&](const Vec2& p) {
    return at_rest.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
  };
  EXPECT_TRUE(std::equal(pixel(a), pixel(a) + 4, pixel(b)));
}

TEST_F(ComparePoses, MessagesAreKeptAsTextThatIsCopied) {
  editor().messages().toast(ToastKind::error, "The first of them");
  editor().messages().toast(ToastKind::notice, "The second of them");
  headless_.key(Key::k, {.control = true});
  headless_.type("messages");
  headless_.key(Key::enter);
  headless_.settle();
  headless_.click({338, 572});
  EXPECT_NE(clipboard_.find("error: The first of them\n"), std::string::npos) << clipboard_;
  EXPECT_NE(clipboard_.find("The second of them\n"), std::string::npos);
}

}  // namespace
}  // namespace foldless::test
