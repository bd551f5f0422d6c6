// SPDX-License-Identifier: GPL-3.0-or-later
// Side panels made wider and narrower with the mouse: the whole editor off screen.
#include <gtest/gtest.h>

#include "app/gui/settings.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

class PanelEdges : public testing::Test {
 protected:
  /// Framebuffer pixels are those of the window, which is large enough for twice the scale.
  void open(HeadlessEditor& headless, float scale = 1) {
    headless.set_content_scale(1);
    headless.ui().settings().scale = scale;
    headless.editor().files().open_shape(bar(4, 1, 3), "bar");
    headless.settle();
  }
  static Vec2 left_edge(HeadlessEditor& headless) {
    const Rectangle& left = headless.ui().layout().left;
    return {left.x + left.width, left.y + 150};
  }
  static Vec2 right_edge(HeadlessEditor& headless) {
    const Rectangle& right = headless.ui().layout().right;
    return {right.x, right.y + 150};
  }
  static void drag(HeadlessEditor& headless, const Vec2& from, double by) {
    headless.press(from);
    headless.move(from + Vec2(by / 2, 0));
    headless.move(from + Vec2(by, 0));
    headless.release(from + Vec2(by, 0));
    headless.settle();
  }
};

TEST_F(PanelEdges, AreDraggedAndRememberedAndADoubleClickTakesThatBack) {
  const TemporaryFolder folder;
  for (const float scale : {0.75F, 1.0F, 2.0F}) {
    {
      HeadlessEditor headless({2400, 900}, {.state_folder = folder.path()});
      open(headless, scale);
      const Layout before = headless.ui().layout();
      drag(headless, left_edge(headless), 60 * scale);
      drag(headless, right_edge(headless), -40 * scale);
      EXPECT_NEAR(headless.ui().layout().left.width, before.left.width + 60 * scale, 2);
      EXPECT_NEAR(headless.ui().layout().right.width, before.right.width + 40 * scale, 2);
      EXPECT_EQ(headless.ui().cursor(), CursorShape::resize) << scale;
      headless.move({before.canvas.x + 200, 300});
      headless.settle();
      EXPECT_NE(headless.ui().cursor(), CursorShape::resize);
    }
    const Settings kept = load_settings(settings_file(folder.path()));
    EXPECT_NEAR(kept.panel_widths.left, 288, 2);
    EXPECT_NEAR(kept.panel_widths.right, 324, 2);
    HeadlessEditor headless({2400, 900}, {.state_folder = folder.path()});
    open(headless, scale);
    EXPECT_NEAR(headless.ui().layout().left.width, 288 * scale, 2 * scale);
    for (int click = 0; click < 2; ++click) headless.click(left_edge(headless));
    for (int click = 0; click < 2; ++click) headless.click(right_edge(headless));
    EXPECT_EQ(headless.ui().settings().panel_widths, PanelWidths{});
  }
}

TEST_F(PanelEdges, StopWhereThePanelWouldBeTooNarrowOrTheCanvasToo) {
  HeadlessEditor headless({1280, 800});
  open(headless);
  drag(headless, left_edge(headless), -200);
  EXPECT_EQ(headless.ui().layout().left.width, kNarrowestPanels.left);
  drag(headless, right_edge(headless), -700);
  EXPECT_GE(headless.ui().layout().canvas.width, 1280 / 3);
}

TEST_F(PanelEdges, ASmallWindowLeavesTheRememberedWidth) {
  const TemporaryFolder folder;
  Settings wide;
  wide.panel_widths = {500, 600};
  save_settings(settings_file(folder.path()), wide);
  {
    HeadlessEditor headless({1000, 700}, {.state_folder = folder.path()});
    open(headless);
    EXPECT_GE(headless.ui().layout().canvas.width, 1000 / 3);
    EXPECT_LT(headless.ui().layout().left.width, 400);
  }
  EXPECT_EQ(load_settings(settings_file(folder.path())).panel_widths, wide.panel_widths);
}

TEST_F(PanelEdges, AClickOnOneChangesNothing) {
  HeadlessEditor headless({1280, 800});
  open(headless);
  const PanelWidths before = headless.ui().settings().panel_widths;
  headless.click(left_edge(headless) + Vec2(2, 0));
  headless.settle();
  EXPECT_EQ(headless.ui().settings().panel_widths, before);
  EXPECT_TRUE(headless.editor().document().handles.empty()) << "the canvas is not reached";
}

}  // namespace
}  // namespace foldless::test
