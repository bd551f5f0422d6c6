// SPDX-License-Identifier: GPL-3.0-or-later
// The strip of tools, with the mouse.
#include <gtest/gtest.h>

#include "app/editor/mirroring.h"
#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class ToolStrip : public testing::Test {
 protected:
  ToolStrip() {
    editor().files().open_shape(bar(4, 1, 3), "bar");
    headless_.calm_down();
  }
  Editor& editor() { return headless_.editor(); }
  /// The icons of the strip from the top; a gap of its own stands between groups.
  void click(int icon, int groups_before) {
    const Rectangle& strip = headless_.ui().layout().strip;
    headless_.click({strip.x + strip.width / 2, strip.y + 23 + icon * 32 + groups_before * 9});
    headless_.settle();
  }

  HeadlessEditor headless_;
};

TEST_F(ToolStrip, EveryIconDoesWhatItsTooltipSays) {
  click(1, 0);
  EXPECT_TRUE(editor().brush().is_on());
  click(2, 0);
  EXPECT_TRUE(editor().bone_tool().is_on());
  EXPECT_FALSE(editor().brush().is_on()) << "one tool is in the hand";
  click(0, 0);
  EXPECT_FALSE(editor().bone_tool().is_on());
  click(3, 0);
  EXPECT_TRUE(is_mirror_on(editor()));
  click(3, 0);
  EXPECT_FALSE(is_mirror_on(editor()));
  headless_.click(headless_.window_point(headless_.position(0)));
  ASSERT_EQ(editor().document().handles.size(), 1U);
  click(6, 1);
  EXPECT_EQ(editor().document().handles.front().kind, HandleKind::pin);
  click(7, 1);
  EXPECT_GT(editor().document().handles.front().depth, 0);
  click(8, 1);
  EXPECT_EQ(editor().document().handles.front().depth, 0);
  click(9, 1);
  EXPECT_TRUE(editor().document().handles.empty());
  click(10, 2);
  EXPECT_EQ(editor().document().handles.size(), 1U) << "undo";
  click(11, 2);
  EXPECT_TRUE(editor().document().handles.empty()) << "redo";
  const bool showed_mesh = editor().view().is_mesh_shown();
  click(14, 3);
  EXPECT_NE(editor().view().is_mesh_shown(), showed_mesh);
  click(15, 3);
  EXPECT_EQ(editor().view().beside(), Beside::rest_mesh);
}

TEST_F(ToolStrip, WhatCannotBeDoneIsGreyed) {
  const std::size_t steps = editor().draft().history().steps().size();
  for (const int icon : {4, 5, 6, 7, 8, 9}) click(icon, 1);  // nothing is selected
  click(10, 2);                                              // nothing to undo
  click(16, 3);                                              // nothing to race about
  EXPECT_EQ(editor().draft().history().steps().size(), steps);
  EXPECT_FALSE(editor().race().is_open());
}

TEST_F(ToolStrip, GoesWithThePanels) {
  headless_.key(Key::f4);
  EXPECT_EQ(headless_.ui().layout().strip.width, 0);
  EXPECT_EQ(headless_.ui().layout().canvas.x, 0);
}

}  // namespace
}  // namespace foldless::test
