// SPDX-License-Identifier: GPL-3.0-or-later
// What keys and panel do to the selected handles: turn, scale, nudge, kinds; and the lasso.
#include "app/editor/handle_edits.h"

#include <numbers>

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// Handles 0 … 3 on the corners of a grid of side 4, all selected.
class HandleEdits : public EditorTest {
 protected:
  HandleEdits() {
    open_grid(5);
    for (const int vertex : {0, 4, 20, 24}) place(vertex);
    editor_->selection().select_all();
  }

  std::size_t steps() const { return editor_->draft().history().steps().size(); }
  void type(const std::vector<Key>& keys) {
    for (const Key k : keys) key(k);
  }
  /// Moves the pointer round the middle of the grid.
  void move_round(double degrees, Modifiers modifiers = {}) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec2 at = pixel_of(Vec2(2 + std::cos(angle), 2 + std::sin(angle)));
    editor_->receive(PointerMoved{at, modifiers}, now_);
    frame();
  }
  void expect_turned(double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec2 corner = Vec2(2 + 2 * (-std::cos(angle) + std::sin(angle)),
                             2 + 2 * (-std::sin(angle) - std::cos(angle)));
    EXPECT_LT((target(0) - corner).norm(), 1e-9) << target(0).transpose();
    EXPECT_LT((target(3) - (Vec2(4, 4) - corner)).norm(), 1e-9);
  }
};

TEST_F(HandleEdits, TurnFollowsThePointerUntilAClick) {
  const std::size_t before = steps();
  move_round(0);
  key(Key::r);
  EXPECT_TRUE(editor_->draft().is_editing());
  for (const double degrees : {20.0, 90.0, 170.0, 200.0}) move_round(degrees);
  expect_turned(200);  // and not by -160
  EXPECT_NE(editor_->input().words().find("200"), std::string::npos) << editor_->input().words();
  click(pixel_of(Vec2(2, 3)));
  EXPECT_FALSE(editor_->draft().is_editing());
  EXPECT_EQ(editor_->document().handles.size(), 4U) << "the click places nothing";
  EXPECT_EQ(steps(), before + 1);
  settle();
  EXPECT_TRUE(is_valid());
  key(Key::z, kControl);
  expect_turned(0);
}

TEST_F(HandleEdits, ShiftSnapsToFifteenDegrees) {
  move_round(0);
  key(Key::r);
  move_round(50, kShift);
  expect_turned(45);
  move_round(50);
  expect_turned(50);
}

TEST_F(HandleEdits, ANumberCanBeTyped) {
  move_round(0);
  key(Key::r);
  type({Key::minus, Key::digit_9, Key::digit_9, Key::backspace, Key::digit_0});
  expect_turned(-90);
  move_round(33);
  expect_turned(-90);
  type({Key::backspace, Key::backspace, Key::backspace, Key::backspace});
  expect_turned(33);  // by hand again, and no handle is deleted
  type({Key::minus, Key::digit_9, Key::digit_0, Key::enter});
  EXPECT_FALSE(editor_->draft().is_editing());
  expect_turned(-90);

  key(Key::s);
  type({Key::digit_1, Key::period, Key::digit_5, Key::enter});
  EXPECT_NEAR((target(3) - target(0)).norm(), 1.5 * std::sqrt(32), 1e-9);
}

TEST_F(HandleEdits, EscapeAndTheOtherButtonsTakeItBack) {
  const Document before = editor_->document();
  key(Key::s);
  move(pixel_of(Vec2(6, 6)));
  key(Key::escape);
  EXPECT_EQ(editor_->document().handles, before.handles);
  EXPECT_FALSE(editor_->draft().is_editing());
  key(Key::r);
  move_round(70);
  press(pixel_of(Vec2(2, 2)), {}, Button::right);
  release(pixel_of(Vec2(2, 2)), Button::right);
  EXPECT_EQ(editor_->document().handles, before.handles);
  EXPECT_FALSE(editor_->draft().is_editing());
}

TEST_F(HandleEdits, OneHandleHasNothingToScale) {
  editor_->selection().select({1});
  key(Key::s);
  EXPECT_FALSE(editor_->draft().is_editing());
}

TEST_F(HandleEdits, ArrowsNudgeByAPixelOfTheScreen) {
  editor_->selection().select({3});
  const double pixel = 1 / editor_->canvas().camera.pixels_per_unit;
  const Vec2 before = target(3);
  const std::size_t step_count = steps();
  key(Key::right);
  key(Key::up, kShift);
  key(Key::down, {.alt = true});
  EXPECT_LT((target(3) - before - pixel * Vec2(1, 9.9)).norm(), 1e-9);
  EXPECT_EQ(steps(), step_count + 1) << "one step within a second";
  EXPECT_EQ(target(0), Vec2(0, 0));
  settle();
  EXPECT_LT((position(3) - target(3)).norm(), 1e-6);
  key(Key::z, kControl);
  EXPECT_EQ(target(3), before);
}

TEST_F(HandleEdits, ANudgeOfAnEarlierIterationBeginsThere) {
  editor_->selection().select({3});
  drag(pixel_of_handle(3), pixel_of_handle(3) + Vec2(150, -90));
  settle();
  ASSERT_GT(editor_->playback().iterations().size(), 1U);
  editor_->playback().scrub(0);
  ASSERT_TRUE(editor_->playback().scrubbed());
  const Points seen = editor_->shown()->deformed;
  key(Key::right);
  EXPECT_FALSE(editor_->playback().scrubbed());
  EXPECT_EQ(editor_->document().pose->deformed, seen);
}

TEST_F(HandleEdits, KTogglesPinsAndTheKindIsUndone) {
  editor_->selection().select({1, 2});
  key(Key::k);
  EXPECT_EQ(selected_handles(*editor_).kind, HandleKind::pin);
  EXPECT_EQ(find_handle(editor_->document(), 0)->kind, HandleKind::drag);
  editor_->selection().select({0, 1});
  EXPECT_FALSE(selected_handles(*editor_).kind) << "they differ";
  key(Key::z, kControl);
  EXPECT_EQ(find_handle(editor_->document(), 1)->kind, HandleKind::drag);
}

TEST_F(HandleEdits, ASoftHandleGivesWayByItsWeight) {
  editor_->selection().select({3});
  const Vec2 from = pixel_of_handle(3);
  drag(from, from + Vec2(120, -60));
  set_kind(*editor_, HandleKind::soft);
  std::vector<double> residuals;
  for (const double weight : {0.001, 1000.0}) {
    set_weight(*editor_, weight);
    settle();
    residuals.push_back((position(3) - target(3)).norm());
  }
  EXPECT_LT(residuals[1], residuals[0]);
  set_weight(*editor_, 1e9);
  EXPECT_EQ(selected_handles(*editor_).weight, 1000);
  set_weight(*editor_, std::nan(""));
  EXPECT_EQ(selected_handles(*editor_).weight, 1000);
}

TEST_F(HandleEdits, WithLHeldADragIsALasso) {
  editor_->selection().select({});
  editor_->receive(KeyPressed{Key::l, {}, false}, now_);
  // Round the lower left and the upper right corner, over the mesh, past the other two.
  press(pixel_of(Vec2(-1, -1)));
  for (const Vec2& world : {Vec2(1, -1), Vec2(5, 3), Vec2(5, 5), Vec2(3, 5)}) move(pixel_of(world));
  EXPECT_GE(editor_->input().lasso().size(), 5U);
  release(pixel_of(Vec2(-1, 1)));
  editor_->receive(KeyReleased{Key::l}, now_);
  EXPECT_EQ(editor_->selection().ids(), (std::set<int>{0, 3}));
  EXPECT_EQ(editor_->document().handles.size(), 4U);
  EXPECT_TRUE(editor_->input().lasso().empty());
  // Without L the same press on the mesh places a handle.
  click(pixel_of(Vec2(1.5, 2.2)));
  EXPECT_EQ(editor_->document().handles.size(), 5U);
}

}  // namespace
}  // namespace foldless::test
