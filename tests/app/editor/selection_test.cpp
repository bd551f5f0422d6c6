// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// Handles 0 … 3 on the corners of a grid: lower left, lower right, upper left, upper right.
class Selection : public EditorTest {
 protected:
  Selection() {
    open_grid(5);
    for (const int vertex : {0, 4, 20, 24}) place(vertex);
    editor_->selection().select({});
  }

  /// A rectangle round the left pair of handles, begun on empty canvas.
  void band_round_left_pair(Modifiers modifiers = {}) {
    drag(pixel_of_handle(2) + Vec2(-25, -25), pixel_of_handle(0) + Vec2(25, 25), modifiers);
  }
};

TEST_F(Selection, DragOnEmptySelectsWhatIsInTheBand) {
  press(pixel_of_handle(2) + Vec2(-25, -25));
  move(pixel_of_handle(0) + Vec2(25, 25));
  EXPECT_TRUE(editor_->input().band().has_value());
  release(pixel_of_handle(0) + Vec2(25, 25));
  EXPECT_FALSE(editor_->input().band().has_value());
  EXPECT_EQ(editor_->selection().ids(), (std::set<int>{0, 2}));
}

TEST_F(Selection, ShiftBandAddsAndControlBandSubtracts) {
  editor_->selection().select({3});
  band_round_left_pair(kShift);
  EXPECT_EQ(editor_->selection().ids(), (std::set<int>{0, 2, 3}));
  band_round_left_pair(kControl);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{3});
}

TEST_F(Selection, EscapeTakesTheBandBack) {
  editor_->selection().select({3});
  press(pixel_of_handle(2) + Vec2(-25, -25));
  move(pixel_of_handle(0) + Vec2(25, 25));
  key(Key::escape);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{3});
  EXPECT_FALSE(editor_->input().band().has_value());
}

TEST_F(Selection, ShiftClickToggles) {
  click(pixel_of_handle(1));
  click(pixel_of_handle(2), kShift);
  EXPECT_EQ(editor_->selection().ids(), (std::set<int>{1, 2}));
  click(pixel_of_handle(1), kShift);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{2});
}

TEST_F(Selection, ClickOnOneOfManySelectsItAlone) {
  editor_->selection().select_all();
  click(pixel_of_handle(1));
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{1});
}

TEST_F(Selection, ClickOnEmptySelectsNone) {
  editor_->selection().select_all();
  click(Vec2(3, 3));
  EXPECT_TRUE(editor_->selection().ids().empty());
  EXPECT_EQ(editor_->document().handles.size(), 4U);
}

TEST_F(Selection, KeysSelectAllNoneAndTheOthers) {
  key(Key::a, kControl);
  EXPECT_EQ(editor_->selection().ids().size(), 4U);
  key(Key::a, kControlShift);
  EXPECT_TRUE(editor_->selection().ids().empty());
  editor_->selection().select({1});
  key(Key::i, kControl);
  EXPECT_EQ(editor_->selection().ids(), (std::set<int>{0, 2, 3}));
}

TEST_F(Selection, DeleteLeavesTheShapeWhereItIs) {
  const Vec2 from = pixel_of_handle(3);
  drag(from, from + Vec2(-30, 20));
  settle();
  const Points before = editor_->document().pose->deformed;
  editor_->selection().select_all();
  key(Key::del);
  EXPECT_TRUE(editor_->document().handles.empty());
  EXPECT_TRUE(editor_->selection().ids().empty());
  settle();
  EXPECT_EQ(editor_->document().pose->deformed, before);
}

TEST_F(Selection, IdsAreNotUsedTwice) {
  editor_->selection().select({3});
  key(Key::backspace);
  EXPECT_EQ(place(24), 4);
}

TEST_F(Selection, LostHandlesAreNotSelectedAfterUndo) {
  const int id = place(12);
  EXPECT_TRUE(editor_->selection().ids().contains(id));
  key(Key::z, kControl);
  EXPECT_FALSE(editor_->selection().ids().contains(id));
}

}  // namespace
}  // namespace foldless::test
