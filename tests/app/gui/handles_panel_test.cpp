// SPDX-License-Identifier: GPL-3.0-or-later
// The list of handles and what the selected one has, by mouse and keys.
#include <gtest/gtest.h>

#include "core/mesh/generate.h"
#include "tests/app/gui/headless_editor.h"

namespace foldless::test {
namespace {

/// A strip with handles along its lower side; the first is selected.
class HandlesPanel : public testing::Test {
 protected:
  explicit HandlesPanel() {
    editor().files().open_shape(grid({.columns = 12, .rows = 2, .width = 6}), "strip");
    headless_.calm_down();
  }

  Editor& editor() { return headless_.editor(); }
  void place(int count) {
    for (int v = 0; v < count; ++v)
      headless_.click(headless_.window_point(editor().shown()->deformed.col(v)));
    editor().selection().select({0});
    headless_.calm_down();
  }
  const Handle& first() { return editor().document().handles.front(); }
  /// Into the field that lies at some height of the panel.
  void type_into(double y, std::string_view words) {
    headless_.click({180, y});
    headless_.key(Key::a, {.control = true});
    headless_.type(words);
    headless_.key(Key::enter);
    headless_.settle();
  }

  HeadlessEditor headless_;
};

constexpr double kFirstField = 317, kField = 26;  // below one row

TEST_F(HandlesPanel, ANameIsTypedAndSearched) {
  place(1);
  type_into(kFirstField, "left paw");
  EXPECT_EQ(first().name, "left paw");
  const Image named = headless_.picture();
  headless_.key(Key::z, kControl);
  EXPECT_EQ(first().name, "");
  headless_.settle();
  EXPECT_GT(differing_pixels(named, headless_.picture()), 50);
}

TEST_F(HandlesPanel, ANameIsEditedInItsRowAfterADoubleClickOrF2) {
  place(2);
  const auto row = headless_.find_words("Vertex 1");
  ASSERT_TRUE(row.has_value());
  headless_.click(*row);
  headless_.click(*row);
  headless_.type("right paw");
  headless_.key(Key::enter);
  EXPECT_EQ(editor().document().handles.at(1).name, "right paw");
  EXPECT_EQ(editor().selection().ids(), std::set<int>{1});
  headless_.key(Key::f2);
  headless_.type("tail");
  headless_.key(Key::escape);
  EXPECT_EQ(editor().document().handles.at(1).name, "right paw") << "Esc leaves it";
  headless_.key(Key::f2);
  headless_.type("tail");
  headless_.key(Key::enter);
  EXPECT_EQ(editor().document().handles.at(1).name, "tail");
  EXPECT_EQ(first().name, "");
}

TEST_F(HandlesPanel, WhereThereAreManyTheyAreSearched) {
  place(9);
  const Image all = headless_.picture();
  headless_.click({140, 290});
  headless_.type("vrtx11");
  headless_.settle();
  const Image some = headless_.picture();
  EXPECT_EQ(editor().document().handles.size(), 9U);
  EXPECT_GT(differing_pixels(all, some), 1000);
}

TEST_F(HandlesPanel, APositionIsTyped) {
  place(1);
  type_into(kFirstField + 2 * kField, "-0.75");
  type_into(kFirstField + 3 * kField, "0.5");
  EXPECT_EQ(first().target, Vec2(-0.75, 0.5));
}

TEST_F(HandlesPanel, TheMeshTurnsWithAHandleWhenItIsTicked) {
  place(1);
  headless_.click({114, kFirstField + 4 * kField});
  ASSERT_TRUE(first().turn);
  EXPECT_NEAR(first().turn->angle, 0, 1e-9);
  type_into(kFirstField + 5 * kField, "30");
  EXPECT_EQ(first().turn->angle, 30);
  type_into(kFirstField + 6 * kField, "1.25");
  EXPECT_EQ(first().turn->radius, 1.25);
  EXPECT_TRUE(
      headless_.wait_until([&] { return editor().status().kind == StatusKind::converged; }));
  headless_.click({114, kFirstField + 4 * kField});
  EXPECT_FALSE(first().turn);
}

TEST_F(HandlesPanel, TheRingIsDrawnRoundTheSelectedHandleAlone) {
  place(1);
  const Image with_ring = headless_.canvas_picture();
  editor().selection().select_none();
  headless_.settle();
  EXPECT_GT(differing_pixels(with_ring, headless_.canvas_picture()), 150);
}

}  // namespace
}  // namespace foldless::test
