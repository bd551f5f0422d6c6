// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

using Gestures = EditorTest;

TEST_F(Gestures, ClickOnAVertexPlacesAHandleThere) {
  open_grid(5);
  click(pixel_of_vertex(12) + Vec2(3, -2));
  ASSERT_EQ(editor_->document().handles.size(), 1U);
  const Handle& handle = editor_->document().handles.front();
  EXPECT_EQ(handle.vertex, 12);
  EXPECT_EQ(handle.target, editor_->document().pose->deformed.col(12));
  EXPECT_TRUE(editor_->selection().ids().contains(handle.id));
}

TEST_F(Gestures, ClickInsideATriangleInsertsAVertexThere) {
  open_grid(5);
  const Vec2 world(0.7, 0.3);
  click(pixel_of(world));
  ASSERT_EQ(editor_->document().handles.size(), 1U);
  EXPECT_EQ(editor_->document().handles.front().vertex, 25);
  EXPECT_LT((position(0) - world).norm(), 1e-9);
  EXPECT_LT((editor_->shown()->rest->col(25) - world).norm(), 1e-9);
  EXPECT_EQ(editor_->shown()->original_vertices, 25);
  EXPECT_TRUE(is_valid());
}

TEST_F(Gestures, ClickBesideAnEdgeSplitsTheEdge) {
  open_grid(5);
  const int faces = editor_->draft().proof().triangles;
  click(pixel_of(Vec2(0.5, 0.01)));
  ASSERT_EQ(editor_->document().handles.size(), 1U);
  EXPECT_EQ(editor_->draft().proof().triangles, faces + 1);
  EXPECT_LT((position(0) - Vec2(0.5, 0)).norm(), 0.02);
  EXPECT_TRUE(is_valid());
}

TEST_F(Gestures, ClickBesideAHandleSelectsItAndPlacesNone) {
  open_grid(5);
  const int id = place(12);
  editor_->selection().select({});
  click(pixel_of_vertex(12) + Vec2(9, 0));
  EXPECT_EQ(editor_->document().handles.size(), 1U);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{id});
  click(pixel_of_vertex(12) + Vec2(30, 0));
  EXPECT_EQ(editor_->document().handles.size(), 2U);
}

TEST_F(Gestures, NearestOfTwoHandlesWins) {
  open_grid(5);
  const int left = place(11);
  const int right = place(12);
  editor_->view().set_camera({{1.5, 2}, 12});  // 12 pixels lie between the two
  click(pixel_of_vertex(11) + Vec2(5, 0));
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{left});
  click(pixel_of_vertex(11) + Vec2(7, 0));
  EXPECT_EQ(editor_->selection().ids(), std::set<int>{right});
}

TEST_F(Gestures, FourPixelsMoveNothingAndFiveDo) {
  open_grid(5);
  const int id = place(12);
  const Vec2 before = target(id);
  const Vec2 at = pixel_of_handle(id);
  press(at);
  move(at + Vec2(4, 0));
  EXPECT_EQ(target(id), before);
  EXPECT_FALSE(editor_->draft().is_editing());
  move(at + Vec2(5, 0));
  EXPECT_NE(target(id), before);
  release(at + Vec2(5, 0));
}

TEST_F(Gestures, ThresholdGrowsWithTheScaleOfTheInterface) {
  editor_->view().resize(800, 600, 2);
  open_grid(5);
  const int id = place(12);
  const Vec2 at = pixel_of_handle(id);
  press(at);
  move(at + Vec2(7, 0));
  EXPECT_FALSE(editor_->draft().is_editing());
  move(at + Vec2(9, 0));
  EXPECT_TRUE(editor_->draft().is_editing());
  release(at);
}

TEST_F(Gestures, PressAndDragOnBareMeshPlacesAndMovesInOneStep) {
  open_grid(5);
  place(0);
  const std::size_t steps = editor_->draft().history().steps().size();
  const Vec2 from = pixel_of_vertex(24);
  drag(from, from + Vec2(20, -10));
  EXPECT_EQ(editor_->document().handles.size(), 2U);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  EXPECT_LT((pixel_of(target(1)) - from - Vec2(20, -10)).norm(), 1e-6);
}

TEST_F(Gestures, DragMovesTheWholeSelection) {
  open_grid(5);
  const int a = place(0);
  const int b = place(4);
  editor_->selection().select({a, b});
  const Vec2 before = target(b);
  const Vec2 from = pixel_of_handle(a);
  drag(from, from + Vec2(30, 0));
  const double by = 30 / editor_->canvas().camera.pixels_per_unit;
  EXPECT_LT((target(b) - before - Vec2(by, 0)).norm(), 1e-9);
}

TEST_F(Gestures, DraggedHandleReachesItsTarget) {
  open_grid(6);
  place(0);
  const int id = place(35);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(15, -25));
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  EXPECT_LT((position(id) - target(id)).norm(), target_tolerance(editor_->document()));
  EXPECT_TRUE(is_valid());
}

TEST_F(Gestures, AHandlePlacedOnTheDeformedMeshMovesNothing) {
  open_grid(6);
  place(0);
  const int id = place(35);
  drag(pixel_of_handle(id), pixel_of_handle(id) + Vec2(60, -90));
  settle();
  const Points before = editor_->shown()->deformed;
  place(14);
  settle();
  // The solver goes on towards a minimum that it had found but for its tolerance.
  EXPECT_LT((editor_->shown()->deformed - before).colwise().norm().maxCoeff(), 0.01);
}

TEST_F(Gestures, EscapeInADragPutsEverythingBack) {
  open_grid(5);
  place(0);
  const int id = place(24);
  settle();
  const Document before = editor_->document();
  const std::size_t steps = editor_->draft().history().steps().size();
  const Vec2 from = pixel_of_handle(id);
  press(from);
  for (int k = 1; k <= 5; ++k) {
    move(from + Vec2(-10, 12) * k);
    frame();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  frame();
  key(Key::escape);
  EXPECT_TRUE(is_same_content(editor_->document(), before));
  EXPECT_EQ(editor_->draft().history().steps().size(), steps);
  release(from);
  frame();
  EXPECT_TRUE(is_same_content(editor_->document(), before));
}

TEST_F(Gestures, AnotherButtonDoesNotEndADrag) {
  open_grid(5);
  const int id = place(12);
  const Vec2 from = pixel_of_handle(id);
  press(from);
  move(from + Vec2(20, 0));
  release(from, Button::right);
  EXPECT_TRUE(editor_->draft().is_editing());
  release(from);
  EXPECT_FALSE(editor_->draft().is_editing());
}

TEST_F(Gestures, LosingTheFocusEndsADragAsAStep) {
  open_grid(5);
  const int id = place(12);
  const Vec2 from = pixel_of_handle(id);
  press(from);
  move(from + Vec2(20, 0));
  const Vec2 moved = target(id);
  editor_->receive(FocusLost{}, now_);
  EXPECT_FALSE(editor_->draft().is_editing());
  EXPECT_EQ(target(id), moved);
}

TEST_F(Gestures, MiddleDragRightDragAndSpaceDragPan) {
  open_grid(5);
  const auto pans = [&](Button button) {
    const Vec2 before = pixel_of_vertex(12);
    press(Vec2(20, 20), {}, button);
    move(Vec2(50, 35));
    release(Vec2(50, 35), button);
    return ((pixel_of_vertex(12) - before) - Vec2(30, 15)).norm() < 1e-6;
  };
  EXPECT_TRUE(pans(Button::middle));
  EXPECT_TRUE(pans(Button::right));
  editor_->receive(KeyPressed{Key::space, {}, false}, now_);
  EXPECT_TRUE(pans(Button::left));
  const SolvingState before = editor_->playback().state();
  editor_->receive(KeyReleased{Key::space}, now_ + 0.1);
  EXPECT_EQ(editor_->playback().state(), before) << "a pan is not a tap";
}

TEST_F(Gestures, WheelZoomsAboutThePointer) {
  open_grid(5);
  const Vec2 pixel(123, 456);
  const Vec2 world = editor_->canvas().to_world(pixel);
  const double before = editor_->canvas().camera.pixels_per_unit;
  editor_->receive(WheelTurned{2, pixel}, now_);
  EXPECT_GT(editor_->canvas().camera.pixels_per_unit, before);
  EXPECT_LT((pixel_of(world) - pixel).norm(), 1e-6);
}

TEST_F(Gestures, HoverIsTheHandleUnderThePointer) {
  open_grid(5);
  const int id = place(12);
  move(pixel_of_vertex(12) + Vec2(2, 2));
  EXPECT_EQ(editor_->selection().hovered(), id);
  frame();
  move(Vec2(2, 2));
  EXPECT_FALSE(editor_->selection().hovered().has_value());
  EXPECT_TRUE(frame()) << "the change is to be drawn";
}

}  // namespace
}  // namespace foldless::test
