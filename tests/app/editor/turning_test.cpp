// SPDX-License-Identifier: GPL-3.0-or-later
// Handles with which the mesh turns: by the ring, by R, by numbers.
#include "app/editor/turning.h"

#include <numbers>

#include "app/editor/handle_edits.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// Handle 0 in the middle of a grid of side 8, selected; two corners are held.
class Turning : public EditorTest {
 protected:
  Turning() {
    open_grid(9);
    place(0);
    place(80);
    id_ = place(40);
    frame();
  }

  const Handle& handle() const { return *find_handle(editor_->document(), id_); }
  std::size_t steps() const { return editor_->draft().history().steps().size(); }
  /// On the ring, `degrees` counter-clockwise from its right.
  Vec2 on_ring(double degrees) const {
    const HandleRing ring = *handle_ring(*editor_);
    const double angle = degrees * std::numbers::pi / 180;
    return ring.centre + ring.radius * Vec2(std::cos(angle), -std::sin(angle));
  }
  void drag_ring(double to, Modifiers modifiers = {}) {
    press(on_ring(0));
    for (double angle = 10; angle <= to; angle += 10) {
      editor_->receive(PointerMoved{on_ring(angle), modifiers}, now_);
      frame();
    }
    editor_->receive(PointerMoved{on_ring(to), modifiers}, now_);
    release(on_ring(to));
  }
  /// Of the edge from the middle to its right neighbour, in degrees.
  double direction() const {
    const Vec2 way =
        editor_->document().pose->deformed.col(41) - editor_->document().pose->deformed.col(40);
    return std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
  }

  int id_ = 0;
};

TEST_F(Turning, TheRingIsThereForOneHandle) {
  ASSERT_TRUE(handle_ring(*editor_));
  EXPECT_LT((handle_ring(*editor_)->centre - pixel_of_handle(id_)).norm(), 1e-9);
  EXPECT_FALSE(handle_ring(*editor_)->reach);
  editor_->selection().select_all();
  EXPECT_FALSE(handle_ring(*editor_));
  editor_->selection().select_none();
  EXPECT_FALSE(handle_ring(*editor_));
}

TEST_F(Turning, TheRingTurnsTheMeshRoundTheHandle) {
  const std::size_t before = steps();
  const Vec2 target = handle().target;
  drag_ring(200);
  EXPECT_EQ(steps(), before + 1);
  ASSERT_TRUE(handle().turn);
  EXPECT_NEAR(handle().turn->angle, 200, 1e-6) << "and not -160";
  EXPECT_EQ(handle().target, target);
  settle();
  EXPECT_TRUE(is_valid());
  EXPECT_NEAR(direction(), -160, 0.01);
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  key(Key::z, kControl);
  EXPECT_FALSE(handle().turn);
  EXPECT_NEAR(direction(), 0, 1e-9);
}

TEST_F(Turning, GoesOnFromTheAngleItHasAndSnapsToMultiplesOf15) {
  drag_ring(50);
  drag_ring(50, kShift);
  EXPECT_NEAR(handle().turn->angle, 105, 1e-9);
}

TEST_F(Turning, AClickOnTheRingPlacesAHandleAsAnywhere) {
  click(on_ring(90));
  EXPECT_FALSE(handle().turn);
  EXPECT_EQ(editor_->document().handles.size(), 4U);
}

TEST_F(Turning, ThereAndBackIsNoStep) {
  const std::size_t before = steps();
  press(on_ring(0));
  move(on_ring(40));
  move(on_ring(0));
  release(on_ring(0));
  EXPECT_EQ(steps(), before);
  EXPECT_FALSE(handle().turn);
}

TEST_F(Turning, EscTakesItBack) {
  const std::size_t before = steps();
  press(on_ring(0));
  move(on_ring(60));
  frame();
  ASSERT_TRUE(handle().turn);
  key(Key::escape);
  EXPECT_FALSE(handle().turn);
  EXPECT_EQ(steps(), before);
}

TEST_F(Turning, RTurnsOneHandleToo) {
  move(pixel_of(Vec2(7, 4)));
  key(Key::r);
  for (const Key k : {Key::digit_3, Key::digit_0, Key::enter}) key(k);
  ASSERT_TRUE(handle().turn);
  EXPECT_NEAR(handle().turn->angle, 30, 1e-9);
  settle();
  EXPECT_NEAR(direction(), 30, 0.01);
  const std::size_t before = steps();
  key(Key::s);
  key(Key::enter);
  EXPECT_EQ(steps(), before) << "there is nothing to scale";
}

TEST_F(Turning, RTurnsTheAnglesOfSeveralWithTheirTargets) {
  set_turning(*editor_, true);
  editor_->selection().select_all();
  move(pixel_of(Vec2(7, 4)));
  key(Key::r);
  for (const Key k : {Key::digit_9, Key::digit_0, Key::enter}) key(k);
  EXPECT_NEAR(handle().turn->angle, 90, 1e-9);
}

TEST_F(Turning, BeginsWithTheAngleOfTheMeshAndReachesTheNeighbours) {
  // The whole is turned by its corners.
  editor_->selection().select_all();
  move(pixel_of(Vec2(7, 4)));
  key(Key::r);
  for (const Key k : {Key::digit_4, Key::digit_0, Key::enter}) key(k);
  settle();
  editor_->selection().select({id_});
  const std::size_t before = steps();
  const Points deformed = editor_->document().pose->deformed;
  set_turning(*editor_, true);
  ASSERT_TRUE(handle().turn);
  EXPECT_NEAR(handle().turn->angle, 40, 1e-3);
  EXPECT_GE(handle().turn->radius, std::sqrt(2.0));
  settle();
  EXPECT_LT((editor_->document().pose->deformed - deformed).cwiseAbs().maxCoeff(), 1e-3)
      << "nothing jumps";
  EXPECT_EQ(steps(), before + 1);
  set_turning(*editor_, false);
  EXPECT_FALSE(handle().turn);
}

TEST_F(Turning, NumbersSetAngleAndRadius) {
  set_turning(*editor_, true);
  set_angle(*editor_, 75);
  set_radius(*editor_, 2.5);
  EXPECT_EQ(handle().turn->angle, 75);
  EXPECT_EQ(handle().turn->radius, 2.5);
  for (const double bad : {std::nan(""), -1.0, 0.0}) set_radius(*editor_, bad);
  set_angle(*editor_, INFINITY);
  EXPECT_EQ(*handle().turn, (Turn{75, 2.5}));
  settle();
  EXPECT_NEAR(direction(), 75, 0.01);
}

TEST_F(Turning, ResetPoseTurnsItBack) {
  drag_ring(70);
  settle();
  key(Key::r, kControl);
  settle();
  EXPECT_EQ(handle().turn->angle, 0);
  EXPECT_NEAR(direction(), 0, 1e-6);
}

TEST_F(Turning, IsSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  drag_ring(70);
  set_name(*editor_, "hub");
  settle();
  ASSERT_TRUE(editor_->files().save_as(folder / "turned.json"));
  const Handle saved = handle();
  editor_->files().open(folder / "turned.json");
  EXPECT_EQ(handle(), saved);
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
}

TEST_F(Turning, NamesAndCoordinatesOfTheSelectedAreSteps) {
  const std::size_t before = steps();
  set_name(*editor_, "nose");
  EXPECT_EQ(*selected_handles(*editor_).name, "nose");
  set_coordinate(*editor_, 0, 4.5);
  EXPECT_EQ(handle().target, Vec2(4.5, 4));
  set_coordinate(*editor_, 1, std::nan(""));
  EXPECT_EQ(handle().target, Vec2(4.5, 4));
  EXPECT_EQ(steps(), before + 2);
  settle();
  EXPECT_LT((position(id_) - Vec2(4.5, 4)).norm(), 1e-4);
  editor_->selection().select_all();
  EXPECT_FALSE(selected_handles(*editor_).name) << "they differ";
  set_coordinate(*editor_, 1, 3);
  for (const Handle& each : editor_->document().handles) EXPECT_EQ(each.target.y(), 3);
}

}  // namespace
}  // namespace foldless::test
