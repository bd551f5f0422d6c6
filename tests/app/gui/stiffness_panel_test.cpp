// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness brush in the window.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class StiffnessPanel : public testing::Test {
 protected:
  StiffnessPanel() {
    headless_.editor().files().open_shape(grid({.columns = 12, .rows = 4, .width = 6}), "strip");
    headless_.calm_down();
  }
  /// Across the middle of the strip.
  void paint() {
    const Vec2 middle = headless_.editor().shown()->deformed.rowwise().mean();
    headless_.press(headless_.window_point(middle - Vec2(2, 0)));
    for (const double x : {-1.0, 0.0, 1.0})
      headless_.move(headless_.window_point(middle + Vec2(x, 0)));
    headless_.release(headless_.window_point(middle + Vec2(1, 0)));
    headless_.calm_down();
  }
  /// What the window shows between the panels.
  Image canvas() {
    const Image window = headless_.picture();
    Image part(680, 600);
    for (int y = 0; y < part.height; ++y)
      std::copy_n(window.at(290, 60 + y), 4 * part.width, part.at(0, y));
    return part;
  }

  HeadlessEditor headless_;
};

TEST_F(StiffnessPanel, WhatIsStiffIsTintedWhileTheBrushIsInTheHand) {
  const Image before = canvas();
  headless_.key(Key::b);
  paint();
  headless_.move({5, 5});
  headless_.settle();
  const Image tinted = canvas();
  EXPECT_GT(differing_pixels(before, tinted), 2000);
  headless_.key(Key::b);
  headless_.settle();
  EXPECT_EQ(differing_pixels(before, canvas()), 0);
}

TEST_F(StiffnessPanel, TheBrushIsTakenAndAllRemovedByTheMouse) {
  const Vec2 paint_box{60, 355}, remove_all{190, 355};
  headless_.click(paint_box);
  ASSERT_TRUE(headless_.editor().brush().is_on());
  paint();
  ASSERT_TRUE(headless_.editor().document().stiffness);
  headless_.click(remove_all);
  EXPECT_FALSE(headless_.editor().document().stiffness);
  headless_.click(paint_box);
  EXPECT_FALSE(headless_.editor().brush().is_on());
}

}  // namespace
}  // namespace foldless::test
