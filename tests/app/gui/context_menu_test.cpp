// SPDX-License-Identifier: GPL-3.0-or-later
// The menu of the right button, on handles and beside them.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

class ContextMenus : public testing::Test {
 protected:
  ContextMenus() {
    editor().files().open_shape(bar(4, 1, 3), "bar");
    headless_.calm_down();
    for (const double x : {0.5, 3.5}) headless_.click(on_bar(x));
    headless_.calm_down();
  }
  Editor& editor() { return headless_.editor(); }
  Vec2 on_bar(double x) const { return headless_.window_point({x, 0.5}); }
  void right_click(const Vec2& at) {
    headless_.move(at);
    headless_.press(at, Button::right);
    headless_.release(at, Button::right);
    headless_.calm_down();
  }
  static bool is_open() { return ImGui::GetCurrentContext()->OpenPopupStack.Size > 0; }
  /// Clicks a row of the menu.
  void choose(const std::string& words) {
    const auto row = headless_.find_words(words);
    ASSERT_TRUE(row) << words;
    headless_.click(*row + Vec2(4, 4));
    headless_.calm_down();
  }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_F(ContextMenus, OnAHandleTakesItAndOffersItsCommands) {
  editor().selection().select({1});
  right_click(on_bar(0.5));
  EXPECT_TRUE(is_open());
  EXPECT_EQ(editor().selection().ids(), std::set<int>{0});
  choose("Bring forward");
  EXPECT_EQ(editor().document().handles[0].depth, 1);
  EXPECT_FALSE(is_open());
}

TEST_F(ContextMenus, OnOneOfSeveralSelectedHandlesIsOfAllOfThem) {
  editor().selection().select({0, 1});
  right_click(on_bar(0.5));
  choose("Delete handles or keys");
  EXPECT_TRUE(editor().document().handles.empty());
}

TEST_F(ContextMenus, BesideHandlesIsOfThePicture) {
  right_click(on_bar(2));
  choose("Undo");
  EXPECT_EQ(editor().document().handles.size(), 1U);
}

TEST_F(ContextMenus, ADragOfTheRightButtonMovesTheViewAndOpensNone) {
  const Camera before = editor().canvas().camera;
  headless_.move(on_bar(2));
  headless_.press(on_bar(2), Button::right);
  headless_.move(on_bar(2) + Vec2(40, 20));
  headless_.release(on_bar(2) + Vec2(40, 20), Button::right);
  EXPECT_FALSE(is_open());
  EXPECT_NE(editor().canvas().camera, before);
}

TEST_F(ContextMenus, ATremblingClickDoesNotMoveTheView) {
  const Vec2 at = on_bar(2);
  const Camera before = editor().canvas().camera;
  headless_.move(at);
  headless_.press(at, Button::right);
  headless_.move(at + Vec2(2, 1));
  headless_.release(at + Vec2(2, 1), Button::right);
  EXPECT_EQ(editor().canvas().camera, before);
  EXPECT_TRUE(is_open());
}

TEST_F(ContextMenus, EscClosesThemAndNothingElse) {
  editor().selection().select({0});
  right_click(on_bar(0.5));
  headless_.key(Key::escape);
  EXPECT_FALSE(is_open());
  EXPECT_EQ(editor().selection().ids(), std::set<int>{0});
}

TEST_F(ContextMenus, APressBesideOneClosesItAndPlacesNothing) {
  right_click(on_bar(2));
  headless_.click(on_bar(1.5));
  headless_.calm_down();
  EXPECT_FALSE(is_open());
  EXPECT_EQ(editor().document().handles.size(), 2U);
}

}  // namespace
}  // namespace foldless::test
