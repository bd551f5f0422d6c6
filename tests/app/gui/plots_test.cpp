// SPDX-License-Identifier: GPL-3.0-or-later
// The plots of the convergence panel, with wheel and mouse.
#include <gtest/gtest.h>

#include "tests/app/gui/bent_bar.h"

namespace foldless::test {
namespace {

class Plots : public testing::Test {
 protected:
  /// A bar that was bent by the paper's method.
  Plots() { EXPECT_TRUE(bend_a_bar(headless_)); }
  Editor& editor() { return headless_.editor(); }
  /// The plots without their controls, the pointer beside them.
  Image plots() {
    headless_.move({640, 400});
    const Image window = headless_.picture();
    const Rectangle& panel = headless_.ui().layout().right;
    Image part(static_cast<int>(panel.width), 300);
    for (int y = 0; y < part.height; ++y)
      std::copy_n(window.at(static_cast<int>(panel.x), kFirstPlot + y), 4 * part.width,
                  part.at(0, y));
    return part;
  }
  Vec2 in_plot() {
    const Rectangle& panel = headless_.ui().layout().right;
    return {panel.x + panel.width * 0.6, kFirstPlot + 50.0};
  }
  void turn_wheel(double notches, Modifiers modifiers) {
    headless_.move(in_plot());
    headless_.ui().receive(ModifiersHeld{modifiers});
    headless_.ui().receive(WheelTurned{notches, in_plot()});
    headless_.settle();
    headless_.ui().receive(ModifiersHeld{});
    headless_.settle();
  }

  static constexpr int kFirstPlot = 420;  ///< below the fields of this method [pixels]
  HeadlessEditor headless_{{1280, 900}};
};

TEST_F(Plots, ControlAndTheWheelZoomAndADoubleClickShowsAll) {
  ASSERT_GT(editor().playback().iterations().size(), 4U);
  const Image before = plots();
  turn_wheel(3, kControl);
  EXPECT_GT(differing_pixels(before, plots()), 300);
  for (int i = 0; i < 2; ++i) {
    headless_.press(in_plot());
    headless_.release(in_plot());
  }
  editor().playback().last();
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(before, plots()), 0);
}

TEST_F(Plots, ZoomedInAndOutTheyAreWhatTheyWere) {
  const Image before = plots();
  turn_wheel(3, kControl);
  turn_wheel(-3, kControl);
  EXPECT_EQ(differing_pixels(before, plots()), 0);
}

}  // namespace
}  // namespace foldless::test
