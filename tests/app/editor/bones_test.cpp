// SPDX-License-Identifier: GPL-3.0-or-later
// Bones in the editor: made of selected handles, dragged, deleted, saved.
#include "app/editor/bones.h"

#include <vector>

#include "app/editor/handle_edits.h"
#include "app/editor/turning.h"
#include "tests/app/editor/editor_fixture.h"
#include "tests/support/temporary_folder.h"

namespace foldless::test {
namespace {

/// Four handles in the middle row of a grid of side 8, two apart, the first to be selected is the
/// one at the right.
class EditorBones : public EditorTest {
 protected:
  EditorBones() {
    open_grid(9);
    for (const int vertex : {42, 40, 38, 36}) ids_.push_back(place(vertex));
    frame();
  }

  void make(std::size_t count) {
    click(pixel_of_handle(ids_[0]));
    for (std::size_t i = 1; i < count; ++i) click(pixel_of_handle(ids_[i]), kShift);
    key(Key::j);
  }
  const std::vector<Bones>& bones() const { return editor_->document().rig.bones; }
  std::size_t steps() const { return editor_->draft().history().steps().size(); }
  double length(std::size_t a, std::size_t b) const {
    return (target(ids_[a]) - target(ids_[b])).norm();
  }
  /// From where a handle is.
  void drag_by(std::size_t i, const Vec2& way) {
    const Vec2 from = position(ids_[i]);
    drag(pixel_of(from), pixel_of(from + way));
  }

  std::vector<int> ids_;
};

TEST_F(EditorBones, AreMadeInTheOrderOfTheSelection) {
  const std::size_t before = steps();
  make(3);
  EXPECT_EQ(bones(), std::vector<Bones>({{ids_[0], ids_[1], ids_[2]}}));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>({ids_[2]})) << "to be dragged";
  for (const std::size_t i : {0U, 1U, 2U})
    click(pixel_of_handle(ids_[i]), i > 0 ? kShift : Modifiers{});
  key(Key::j);
  EXPECT_EQ(steps(), before + 1) << "they are there";
  key(Key::z, kControl);
  EXPECT_TRUE(bones().empty());
}

TEST_F(EditorBones, AreSomethingToSave) {
  TemporaryFolder folder;
  ASSERT_TRUE(editor_->files().save_as(folder / "bones.json"));
  const Document saved = editor_->document();
  make(2);
  EXPECT_TRUE(editor_->files().is_dirty());
  Document other = saved;
  other.rig = editor_->document().rig;
  EXPECT_FALSE(is_same_content(saved, other));
}

TEST_F(EditorBones, OneHandleIsNoChain) {
  click(pixel_of_handle(ids_[0]));
  EXPECT_FALSE(editor_->run_command("bones.make"));
  EXPECT_FALSE(editor_->run_command("bones.remove"));
}

TEST_F(EditorBones, HandlesLeaveTheChainThatTheyWereIn) {
  make(4);
  click(pixel_of_handle(ids_[3]));
  click(pixel_of_handle(ids_[1]), kShift);
  key(Key::j);
  EXPECT_EQ(bones(), std::vector<Bones>({{ids_[0], ids_[2]}, {ids_[3], ids_[1]}}));
  key(Key::j, kShift);
  EXPECT_EQ(bones(), std::vector<Bones>({{ids_[0], ids_[2]}}));
}

TEST_F(EditorBones, DraggingTheEndBendsTheJointsInOneStep) {
  make(3);
  const std::size_t before = steps();
  const Vec2 root = target(ids_[0]);
  drag_by(2, {1.5, 1.5});
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(target(ids_[0]), root);
  EXPECT_LT((target(ids_[2]) - Vec2(3.5, 5.5)).norm(), 1e-9) << "the hand is met";
  EXPECT_NEAR(length(0, 1), 2, 1e-12);
  EXPECT_NEAR(length(1, 2), 2, 1e-12);
  EXPECT_NE(target(ids_[1]), Vec2(4, 4)) << "the elbow gave way";
  EXPECT_EQ(target(ids_[3]), Vec2(0, 4)) << "no joint";
  settle();
  EXPECT_TRUE(is_valid());
  EXPECT_LT((position(ids_[1]) - target(ids_[1])).norm(), 1e-3);
  key(Key::z, kControl);
  EXPECT_EQ(target(ids_[1]), Vec2(4, 4));
  EXPECT_EQ(target(ids_[2]), Vec2(2, 4));
}

TEST_F(EditorBones, OutOfReachTheyAreStretchedTowardsTheHand) {
  make(3);
  drag_by(2, {0, 7});
  const Vec2 way = (Vec2(2, 11) - target(ids_[0])).normalized();
  EXPECT_LT((target(ids_[2]) - target(ids_[0]) - 4 * way).norm(), 1e-9);
  EXPECT_LT((target(ids_[1]) - target(ids_[0]) - 2 * way).norm(), 1e-9);
}

TEST_F(EditorBones, LongerChainsKeepTheirLengthsToo) {
  make(4);
  drag_by(3, {3, 2});
  EXPECT_LT((target(ids_[3]) - Vec2(3, 6)).norm(), 1e-8);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(length(i, i + 1), 2, 1e-12) << i;
}

TEST_F(EditorBones, TheRootTakesAllAlong) {
  make(3);
  drag_by(0, {0.5, 0.25});
  EXPECT_EQ(target(ids_[1]), target(ids_[0]) - Vec2(2, 0));
  EXPECT_EQ(target(ids_[2]), target(ids_[0]) - Vec2(4, 0));
}

TEST_F(EditorBones, AMiddleJointCarriesTheRestRigidly) {
  make(4);
  drag_by(1, {-0.5, 1.5});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(length(i, i + 1), 2, 1e-12) << i;
  EXPECT_NEAR(length(0, 3), 6, 1e-9) << "all in one line";
  EXPECT_GT(target(ids_[3]).y(), 5);
}

TEST_F(EditorBones, AHandThatComesBackFindsAllAsItWas) {
  make(4);
  drag_by(3, {1, 2});
  const std::vector<Handle> before = editor_->document().handles;
  const Vec2 from = pixel_of(target(ids_[3]));
  settle();
  press(pixel_of_handle(ids_[3]));
  for (const Vec2& by : {Vec2(50, 20), Vec2(-120, 70), Vec2(200, -100)}) move(from + by);
  move(pixel_of_handle(ids_[3]));
  release(pixel_of_handle(ids_[3]));
  for (const int id : ids_)
    EXPECT_LT((find_handle(editor_->document(), id)->target -
               std::ranges::find(before, id, &Handle::id)->target)
                  .norm(),
              1e-2);
}

TEST_F(EditorBones, EscTakesAllJointsBack) {
  make(3);
  press(pixel_of_handle(ids_[2]));
  move(pixel_of_handle(ids_[2]) + Vec2(60, -60));
  frame();
  ASSERT_NE(target(ids_[1]), Vec2(4, 4));
  key(Key::escape);
  EXPECT_EQ(target(ids_[1]), Vec2(4, 4));
}

TEST_F(EditorBones, NumbersAndArrowsKeepTheLengthsToo) {
  make(3);
  click(pixel_of_handle(ids_[2]));
  set_coordinate(*editor_, 0, 4);
  EXPECT_LT((target(ids_[2]) - Vec2(4, 4)).norm(), 1e-12);
  EXPECT_NEAR(length(0, 1), 2, 1e-12);
  key(Key::up);
  EXPECT_GT(target(ids_[2]).y(), 4);
  EXPECT_NEAR(length(1, 2), 2, 1e-12);
}

TEST_F(EditorBones, AJointThatTurnsTheMeshTurnsWithItsBone) {
  make(3);
  click(pixel_of_handle(ids_[2]));
  set_turning(*editor_, true);
  drag_by(2, {4, 4});  // straight up from the root, out of reach
  const Vec2 bone = target(ids_[2]) - target(ids_[1]);
  const double turn = std::atan2(bone.y(), bone.x()) * 180 / 3.14159265358979 - 180;
  const double angle = find_handle(editor_->document(), ids_[2])->turn->angle;
  EXPECT_NEAR(std::remainder(angle - turn, 360), 0, 1e-6);
  EXPECT_LT(angle, -30);
}

TEST_F(EditorBones, DeletingAJointJoinsItsNeighbours) {
  make(4);
  editor_->selection().select({ids_[1]});
  key(Key::del);
  EXPECT_EQ(bones(), std::vector<Bones>({{ids_[0], ids_[2], ids_[3]}}));
  drag_by(2, {1, 1});
  EXPECT_NEAR(length(0, 2), 4, 1e-12) << "the new bone is as long as at rest";
  editor_->selection().select({ids_[3], ids_[0]});
  key(Key::del);
  EXPECT_TRUE(bones().empty());
  key(Key::z, kControl);
  EXPECT_EQ(bones().size(), 1U);
}

TEST_F(EditorBones, AreSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  make(3);
  drag_by(2, {1, 1});
  settle();
  ASSERT_TRUE(editor_->files().save_as(folder / "bones.json"));
  const std::vector<Bones> saved = bones();
  editor_->files().open(folder / "bones.json");
  EXPECT_EQ(bones(), saved);
  drag_by(2, {1, 0.5});
  EXPECT_NEAR(length(0, 1), 2, 1e-12);
}

/// A grid of side 8 without handles, the tool in the hand.
class DrawnBones : public EditorTest {
 protected:
  DrawnBones() {
    open_grid(9);
    key(Key::n);
    frame();
  }
  /// With a number for every handle in the order of the clicks.
  void click_on(int vertex) {
    click(pixel_of_vertex(vertex));
    frame();
  }
  const std::vector<Bones>& bones() const { return editor_->document().rig.bones; }
  std::size_t handles() const { return editor_->document().handles.size(); }
  std::size_t steps() const { return editor_->draft().history().steps().size(); }
};

TEST_F(DrawnBones, EveryClickAddsAJointInOneStep) {
  const std::size_t before = steps();
  for (const int vertex : {36, 38, 40}) click_on(vertex);
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1, 2}}));
  EXPECT_EQ(steps(), before + 3);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>({2}));
}

TEST_F(DrawnBones, EnterOrEscapeEndsThemAndAnotherChainBegins) {
  for (const int vertex : {36, 38}) click_on(vertex);
  key(Key::enter);
  for (const int vertex : {54, 56}) click_on(vertex);
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1}, {2, 3}}));
  key(Key::escape);
  EXPECT_TRUE(editor_->bone_tool().is_on());
  EXPECT_TRUE(editor_->bone_tool().chain().empty());
  key(Key::escape);
  EXPECT_FALSE(editor_->bone_tool().is_on());
  click_on(60);
  EXPECT_EQ(bones().size(), 2U) << "a handle again";
}

TEST_F(DrawnBones, AClickOnTheLastJointEndsThem) {
  for (const int vertex : {36, 38, 38, 54}) click_on(vertex);
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1}}));
  EXPECT_EQ(handles(), 3U);
}

TEST_F(DrawnBones, GoThroughHandlesThatAreThereAndOnFromTheEndOfOthers) {
  for (const int vertex : {36, 38}) click_on(vertex);
  key(Key::enter);
  click_on(60);
  key(Key::enter);
  for (const int vertex : {38, 60}) click_on(vertex);  // the end of the first ones, then a handle
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1, 2}}));
  EXPECT_EQ(handles(), 3U);
  const std::size_t before = steps();
  click_on(36);  // its own root
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1, 2}}));
  EXPECT_EQ(steps(), before);
}

TEST_F(DrawnBones, GoOnFromWhatIsLeftAfterUndo) {
  for (const int vertex : {36, 38, 40}) click_on(vertex);
  key(Key::z, kControl);
  EXPECT_EQ(bones(), std::vector<Bones>({{0, 1}}));
  EXPECT_EQ(editor_->bone_tool().chain(), (Bones{0, 1}));
  click_on(60);
  ASSERT_EQ(bones().size(), 1U);
  EXPECT_EQ(bones().front().size(), 3U);
}

TEST_F(DrawnBones, AreOfOneMesh) {
  click_on(36);
  open_grid(5);
  editor_->draft().edit("Place", place_handle(editor_->document(), {.vertex = 12}).document,
                        Change::mesh);
  click_on(0);
  EXPECT_TRUE(bones().empty()) << "none from a handle of the mesh before";
  click_on(4);
  EXPECT_EQ(bones(), std::vector<Bones>({{1, 2}}));
  click({2, 2});
  EXPECT_EQ(handles(), 3U) << "nothing beside the mesh";
}

}  // namespace
}  // namespace foldless::test
