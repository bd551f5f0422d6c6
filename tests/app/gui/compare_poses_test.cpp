// SPDX-License-Identifier: GPL-3.0-or-later
// What is compared on the canvas, and the log of messages.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

Image part_of(const Image& whole, const Rectangle& place) {
  Image part(static_cast<int>(place.width), static_cast<int>(place.height));
  for (int y = 0; y < part.height; ++y)
    std::copy_n(whole.at(static_cast<int>(place.x), static_cast<int>(place.y) + y),
                4 * static_cast<std::size_t>(part.width), part.at(0, y));
  return part;
}

class ComparePoses : public testing::Test {
 protected:
  ComparePoses() {
    editor().files().open_shape(grid({.columns = 12, .rows = 4, .width = 6}), "strip");
    headless_.calm_down();
    headless_.click(headless_.window_point(editor().shown()->deformed.col(0)));
    pull({-60, 40});
  }
  /// The other end of the strip.
  void pull(const Vec2& by) {
    const Vec2 from = headless_.window_point(editor().shown()->deformed.col(64));
    headless_.press(from);
    headless_.move(from + by);
    headless_.release(from + by);
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

TEST_F(ComparePoses, SideBySideTheLeftKeepsItsPoseWhileTheRightIsBent) {
  headless_.key(Key::backslash, kControl);
  headless_.calm_down();
  const Rectangle left = headless_.ui().layout().side, right = headless_.ui().layout().canvas;
  ASSERT_GT(left.width, 100);
  EXPECT_TRUE(headless_.find_words("Keep this pose as A"));
  const auto of = [this](const Rectangle& place) { return part_of(headless_.picture(), place); };
  const Image left_before = of(left), right_before = of(right);
  pull({10, -50});
  EXPECT_LT(differing_pixels(left_before, of(left)), 400) << "but for the selected handle";
  EXPECT_GT(differing_pixels(right_before, of(right)), 3000);
  headless_.key(Key::escape);
  headless_.calm_down();
  EXPECT_EQ(headless_.ui().layout().side.width, 0);
}

TEST_F(ComparePoses, SideBySideBothAreMovedByEither) {
  headless_.key(Key::backslash, kControl);
  headless_.calm_down();
  const Rectangle left = headless_.ui().layout().side;
  const Camera before = editor().canvas().camera;
  const Vec2 from(left.x + left.width / 2, left.y + 80);
  headless_.press(from);
  headless_.move(from + Vec2(40, 25));
  headless_.release(from + Vec2(40, 25));
  EXPECT_NEAR(editor().canvas().camera.centre.x, before.centre.x - 40 / before.pixels_per_unit,
              1e-9);
  EXPECT_EQ(editor().view().side_pane().pane().camera, editor().canvas().camera);
}

TEST_F(ComparePoses, SideBySideTheHeatMapsHaveOneScale) {
  editor().view().options().layers.heat = true;
  headless_.key(Key::backslash, kControl);
  pull({30, -20});  // less is left of the bend
  const Image on_common_scale = headless_.canvas_picture();
  editor().run_command("compare.keep");
  headless_.calm_down();
  EXPECT_GT(differing_pixels(on_common_scale, headless_.canvas_picture()), 3000)
      << "the scale goes no further than this pose";
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
