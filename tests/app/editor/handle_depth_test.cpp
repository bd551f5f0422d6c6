// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/handle_edits.h"

#include <limits>

#include "app/editor/picking.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/ribbons.h"

namespace foldless::test {
namespace {

class HandleDepth : public EditorTest {
 protected:
  HandleDepth() {
    open_grid(5);
    left_ = place(0);
    right_ = place(24);
  }
  double depth(int id) const { return find_handle(editor_->document(), id)->depth; }

  int left_ = 0, right_ = 0;
};

TEST_F(HandleDepth, BracketsMoveTheSelectedHandlesByOneAndAnUndoTakesItBack) {
  settle();
  const auto pose = editor_->document().pose;
  editor_->selection().select({right_});
  key(Key::right_bracket);
  key(Key::right_bracket);
  EXPECT_EQ(depth(right_), 2);
  EXPECT_EQ(depth(left_), 0);
  editor_->selection().select({left_, right_});
  key(Key::left_bracket);
  EXPECT_EQ(depth(right_), 1);
  EXPECT_EQ(depth(left_), -1);
  EXPECT_EQ(editor_->draft().history().steps().back().label, "Send back");
  key(Key::z, kControl);
  EXPECT_EQ(depth(right_), 2);
  EXPECT_EQ(depth(left_), 0);
  key(Key::z, kControl);
  key(Key::z, kControl);
  EXPECT_EQ(depth(right_), 0);
  key(Key::z, kControlShift);
  EXPECT_EQ(depth(right_), 1);
  EXPECT_FALSE(editor_->playback().is_solving()) << "the solver has no part in it";
  EXPECT_EQ(editor_->document().pose, pose);
}

TEST_F(HandleDepth, ShowsAtOnce) {
  settle();
  editor_->selection().select({right_});
  key(Key::right_bracket);
  EXPECT_EQ(editor_->shown()->handles[1].depth, 1);
}

TEST_F(HandleDepth, WithoutASelectionThereIsNothingToDo) {
  editor_->selection().select({});
  const std::size_t steps = editor_->draft().history().steps().size();
  EXPECT_FALSE(editor_->run_command("handle.forward"));
  set_depth(*editor_, 3);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps);
  EXPECT_FALSE(selected_handles(*editor_).are_there);
}

TEST_F(HandleDepth, IsGivenAsANumberWithinBounds) {
  editor_->selection().select({left_, right_});
  set_depth(*editor_, 2.5);
  EXPECT_EQ(selected_handles(*editor_).depth, 2.5);
  set_depth(*editor_, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(depth(left_), 2.5);
  set_depth(*editor_, 1e9);
  EXPECT_EQ(depth(left_), 1000);
  const std::size_t steps = editor_->draft().history().steps().size();
  bring_forward(*editor_);
  EXPECT_EQ(depth(left_), 1000);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps) << "nothing changed";
  editor_->selection().select({left_});
  set_depth(*editor_, -1);
  editor_->selection().select({left_, right_});
  EXPECT_TRUE(selected_handles(*editor_).are_there);
  EXPECT_FALSE(selected_handles(*editor_).depth.has_value());
}

TEST_F(HandleDepth, IsSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  editor_->selection().select({left_});
  set_depth(*editor_, -0.25);
  EXPECT_TRUE(editor_->files().is_dirty());
  ASSERT_TRUE(editor_->files().save_as(folder.path() / "scene.json"));
  const Document saved = editor_->document();
  make_editor({});
  editor_->files().open(folder.path() / "scene.json");
  EXPECT_EQ(depth(left_), -0.25);
  EXPECT_TRUE(is_same_content(editor_->document(), saved));
}

TEST_F(HandleDepth, StaysWithAHandleThroughDragsSplitsAndAResetOfThePose) {
  editor_->selection().select({right_});
  set_depth(*editor_, 3);
  const Vec2 from = pixel_of_handle(right_);
  drag(from, from + Vec2(40, -30));
  settle();
  click(pixel_of(Vec2(1.7, 2.4)));  // splits a triangle
  settle();
  EXPECT_EQ(depth(right_), 3);
  EXPECT_EQ(editor_->shown()->handles[1].depth, 3);
  editor_->run_command("edit.reset_pose");
  EXPECT_EQ(depth(right_), 3);
}

TEST_F(HandleDepth, OfAnEarlierIterationIsThatOfNow) {
  const Vec2 from = pixel_of_handle(right_);
  drag(from, from + Vec2(80, 60));
  settle();
  ASSERT_TRUE(editor_->playback().can_scrub());
  editor_->selection().select({right_});
  set_depth(*editor_, 7);
  set_name(*editor_, "hand");
  editor_->playback().scrub(0);
  ASSERT_TRUE(editor_->playback().scrubbed()) << "one iteration was enough";
  EXPECT_EQ(editor_->shown()->handles[1].depth, 7);
  EXPECT_EQ(editor_->shown()->handles[1].name, "hand");
  const Points shown = editor_->shown()->deformed;
  set_depth(*editor_, 8);
  EXPECT_EQ(depth(right_), 8);
  EXPECT_EQ(editor_->document().pose->deformed, shown) << "as any edit of an earlier iteration";
  key(Key::z, kControl);
  EXPECT_EQ(depth(right_), 7);
}

TEST_F(HandleDepth, TheTriangleInFrontIsUnderThePointer) {
  Snapshot crossing = crossing_ribbon();
  for (const double left : {1.0, -1.0}) {
    crossing.handles[0].depth = left;
    const auto triangle = triangle_at(crossing, Vec2(0.01, 0.02), editor_->draft().paint_order());
    ASSERT_TRUE(triangle.has_value());
    EXPECT_EQ((*crossing.rest)(0, (*crossing.triangles)(0, *triangle)) < 0, left > 0);
  }
  EXPECT_FALSE(triangle_at(crossing, Vec2(5, 5), editor_->draft().paint_order()).has_value());
}

}  // namespace
}  // namespace foldless::test
