// SPDX-License-Identifier: GPL-3.0-or-later
// The time line without its window: how keys come about and change.
#include "app/editor/handle_edits.h"
#include "tests/app/editor/motion_fixture.h"

namespace foldless::test {
namespace {

TEST_F(EditorMotion, AMovedHandleGetsAKeyAndOneAtTheStart) {
  const Vec2 before = target(ids_[2]);
  animate();
  ASSERT_EQ(animation().tracks.size(), 1U);
  const auto& track = animation().tracks[0].position;
  ASSERT_EQ(track.size(), 2U);
  EXPECT_EQ(track[0].frame, 0);
  EXPECT_EQ(track[0].value, before);
  EXPECT_EQ(track[1].frame, 8);
  EXPECT_GT((track[1].value - before).norm(), 0.01);
}

TEST_F(EditorMotion, ADragAndItsKeyAreOneUndoStep) {
  const std::size_t steps = editor_->draft().history().steps().size();
  motion().play_head().go_to(8);
  frame();
  drag_handle(ids_[2], {0, -40});
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  editor_->draft().undo();
  EXPECT_TRUE(keys_of(animation()).empty());
}

TEST_F(EditorMotion, AnEditGoesOnFromTheFrame) {
  animate();
  motion().play_head().go_to(4);
  frame();
  const Points shown = editor_->shown()->deformed;
  const Vec2 at = pixel_of(shown_at(ids_[2]));
  press(at);
  move(at + Vec2(6, 0));
  EXPECT_EQ(editor_->document().pose->deformed, shown);
  release(at + Vec2(6, 0));
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 8}));
}

TEST_F(EditorMotion, AHandleWithoutKeysMovesInAllFramesWhereNothingIsRecorded) {
  animate();
  key(Key::i, kShift);
  EXPECT_FALSE(motion().keys().records());
  motion().play_head().go_to(4);
  frame();
  drag_handle(ids_[0], {-20, 0});
  EXPECT_EQ(key_frames(), (std::vector{0, 8}));
  drag_handle(ids_[2], {-20, 0});
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 8})) << "that has keys, and gets one more";
}

TEST_F(EditorMotion, KeysAreSetCopiedPastedAndDeletedByTheKeyboard) {
  editor_->selection().select({ids_[1]});
  motion().play_head().go_to(3);
  key(Key::i);
  EXPECT_EQ(keys_of(animation()), (Keys{{ids_[1], KeyedProperty::position, 3}}));
  motion().keys().select(keys_of(animation()));
  key(Key::c, kControl);
  motion().play_head().go_to(9);
  key(Key::v, kControl);
  EXPECT_EQ(key_frames(), (std::vector{3, 9}));
  EXPECT_EQ(motion().keys().selected(), (Keys{{ids_[1], KeyedProperty::position, 9}}));
  key(Key::del);
  EXPECT_EQ(key_frames(), std::vector{3});
  EXPECT_EQ(editor_->document().handles.size(), 3U) << "keys went, not handles";
  editor_->draft().undo();
  EXPECT_EQ(key_frames(), (std::vector{3, 9}));
}

TEST_F(EditorMotion, EasingPathsAndSwingAreSteps) {
  animate();
  motion().keys().select(keys_of(animation()));
  motion().keys().set_easing(*find_easing("both"));
  EXPECT_EQ(animation().tracks[0].position[0].easing, *find_easing("both"));
  editor_->selection().select({ids_[2]});
  editor_->run_command("motion.smooth");
  EXPECT_TRUE(animation().tracks[0].is_smooth);
  editor_->selection().select({ids_[2]});
  editor_->selection().select({ids_[2], ids_[0]});
  editor_->run_command("motion.swing");
  ASSERT_EQ(animation().groups.size(), 1U);
  EXPECT_EQ(animation().groups[0].handles, std::vector{ids_[2]});
  EXPECT_EQ(animation().groups[0].center, target(ids_[0]));
  editor_->run_command("motion.swing");
  EXPECT_TRUE(animation().groups.empty());
  for (int i = 0; i < 4; ++i) editor_->draft().undo();
  EXPECT_FALSE(animation().tracks[0].is_smooth);
  EXPECT_EQ(animation().tracks[0].position[0].easing, Easing{});
}

TEST_F(EditorMotion, FieldsAreOfTheFrameAndSetAKeyThere) {
  animate();
  motion().play_head().go_to(4);
  frame();
  editor_->selection().select({ids_[2]});
  const auto& track = animation().tracks[0].position;
  const Vec2 middle = (track[0].value + track[1].value) / 2;
  EXPECT_NEAR(*selected_handles(*editor_).y, middle.y(), 1e-12);
  set_coordinate(*editor_, 0, middle.x() + 0.25);
  frame();
  ASSERT_EQ(key_frames(), (std::vector{0, 4, 8}));
  EXPECT_NEAR((animation().tracks[0].position[1].value - middle - Vec2(0.25, 0)).norm(), 0, 1e-12);
}

TEST_F(EditorMotion, NudgesAtAFrameAreOneStepAndOneKey) {
  animate();
  motion().play_head().go_to(4);
  frame();
  editor_->selection().select({ids_[2]});
  const Vec2 before = editor_->shown()->handles.back().target;
  const std::size_t steps = editor_->draft().history().steps().size();
  for (int i = 0; i < 3; ++i) {
    key(Key::right);
    frame();  // waiting for all frames would take the time that parts one step from the next
  }
  solve_all();
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  ASSERT_EQ(key_frames(), (std::vector{0, 4, 8}));
  const Vec2 way = animation().tracks[0].position[1].value - before;
  EXPECT_GT(way.x(), 0);
  EXPECT_NEAR(way.y(), 0, 1e-12);
  editor_->draft().undo();
  EXPECT_EQ(key_frames(), (std::vector{0, 8}));
}

}  // namespace
}  // namespace foldless::test
