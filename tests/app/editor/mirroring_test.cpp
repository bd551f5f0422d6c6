// SPDX-License-Identifier: GPL-3.0-or-later
// The mirror: handles in pairs.
#include "app/editor/mirroring.h"

#include "app/editor/handle_edits.h"
#include "app/editor/turning.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// A grid of side 8 whose axis is found upright through its middle.
class Mirroring : public EditorTest {
 protected:
  Mirroring() {
    open_grid(9);
    key(Key::x);
    frame();
  }
  const std::vector<Handle>& handles() const { return editor_->document().handles; }
  const Rig& rig() const { return editor_->document().rig; }
  Vec2 rest(const Handle& handle) const {
    return editor_->document().pose->rest->col(handle.vertex);
  }
  std::size_t steps() const { return editor_->draft().history().steps().size(); }
};

TEST_F(Mirroring, XFindsTheAxisAndSwitchesItOnAndOff) {
  ASSERT_TRUE(rig().mirror);
  EXPECT_TRUE(is_mirror_on(*editor_));
  EXPECT_LT((rig().mirror->axis.from - Vec2(4, 0)).norm(), 1e-9);
  EXPECT_LT((rig().mirror->axis.to - Vec2(4, 8)).norm(), 1e-9);
  key(Key::x);
  EXPECT_FALSE(is_mirror_on(*editor_));
  EXPECT_TRUE(rig().mirror) << "remembered";
  key(Key::z, kControl);
  EXPECT_TRUE(is_mirror_on(*editor_));
  key(Key::z, kControl);
  EXPECT_FALSE(rig().mirror);
}

TEST_F(Mirroring, AHandleIsPlacedWithItsMirrorImageInOneStep) {
  const std::size_t before = steps();
  click(pixel_of({1.3, 2.4}));
  ASSERT_EQ(handles().size(), 2U);
  EXPECT_LT((rest(handles()[1]) - Vec2(6.7, 2.4)).norm(), 1e-6);
  EXPECT_EQ(editor_->selection().ids(), std::set<int>({handles()[0].id}));
  EXPECT_EQ(steps(), before + 1);
  click(pixel_of({4, 5}));
  EXPECT_EQ(handles().size(), 3U) << "on the axis it is its own";
  key(Key::x);
  click(pixel_of({1, 7}));
  EXPECT_EQ(handles().size(), 4U) << "the mirror is off";
}

TEST_F(Mirroring, BesideTheMeshOneHandleIsPlacedAndItIsSaid) {
  drag(pixel_of({4, 0}), pixel_of({2, 0}));
  drag(pixel_of({4, 8}), pixel_of({2, 8}));
  ASSERT_LT((rig().mirror->axis.to - Vec2(2, 8)).norm(), 1e-9);
  click(pixel_of({7, 3}));
  EXPECT_EQ(handles().size(), 1U);
  ASSERT_FALSE(editor_->messages().toasts().empty());
  EXPECT_NE(editor_->messages().toasts().back().text.find("beside the mesh"), std::string::npos);
}

TEST_F(Mirroring, DraggingOneOfAPairMovesTheOtherMirrored) {
  click(pixel_of({1, 2}));
  const std::size_t before = steps();
  drag(pixel_of({1, 2}), pixel_of({0, 3}));
  EXPECT_LT((handles()[0].target - Vec2(0, 3)).norm(), 1e-9);
  EXPECT_LT((handles()[1].target - Vec2(8, 3)).norm(), 1e-9);
  EXPECT_EQ(steps(), before + 1);
  settle();
  EXPECT_TRUE(is_valid());
  key(Key::z, kControl);
  EXPECT_EQ(handles()[1].target, Vec2(7, 2));
  editor_->selection().select_all();
  drag(pixel_of({1, 2}), pixel_of({2, 2}));
  EXPECT_LT((handles()[1].target - Vec2(8, 2)).norm(), 1e-9) << "it is in the hand itself";
}

TEST_F(Mirroring, PressAndDragPlacesAndMovesBoth) {
  drag(pixel_of({2, 5}), pixel_of({2, 6}));
  ASSERT_EQ(handles().size(), 2U);
  EXPECT_LT((handles()[1].target - Vec2(6, 6)).norm(), 1e-9);
}

TEST_F(Mirroring, BonesMoveTheirPartnersToo) {
  for (const double x : {3.0, 2.0, 1.0}) click(pixel_of({x, 4}));
  ASSERT_EQ(handles().size(), 6U);
  std::vector<int> arm{handles()[0].id, handles()[2].id, handles()[4].id};
  for (std::size_t i = 0; i < 3; ++i) click(pixel_of_handle(arm[i]), i > 0 ? kShift : Modifiers{});
  key(Key::j);
  drag(pixel_of({1, 4}), pixel_of({1.5, 5}));
  for (std::size_t i = 0; i < 6; i += 2) {
    const Vec2 image(8 - handles()[i].target.x(), handles()[i].target.y());
    EXPECT_LT((handles()[i + 1].target - image).norm(), 1e-9) << i;
  }
  EXPECT_NE(handles()[2].target.y(), 4) << "the elbow gave way";
}

TEST_F(Mirroring, PoseMirroredTakesOverFromThePartner) {
  click(pixel_of({1, 2}));
  const int right = handles()[1].id;
  key(Key::x);
  editor_->selection().select({handles()[0].id});
  set_coordinate(*editor_, 1, 3.5);
  EXPECT_EQ(handles()[1].target, Vec2(7, 2));
  click(pixel_of({4, 7}));
  editor_->selection().select({right});
  key(Key::x, kShift);
  EXPECT_LT((handles()[1].target - Vec2(7, 3.5)).norm(), 1e-9);
  EXPECT_EQ(handles()[0].target.y(), 3.5) << "not selected";
  EXPECT_TRUE(editor_->messages().toasts().empty());
}

TEST_F(Mirroring, BothSelectedTheyChangeTheirPoses) {
  click(pixel_of({1, 2}));
  key(Key::x);
  editor_->selection().select({handles()[0].id});
  set_turning(*editor_, true);
  set_angle(*editor_, 30);
  editor_->selection().select({handles()[1].id});
  set_turning(*editor_, true);
  set_coordinate(*editor_, 0, 6);
  editor_->selection().select_all();
  key(Key::x, kShift);
  EXPECT_LT((handles()[0].target - Vec2(2, 2)).norm(), 1e-9);
  EXPECT_LT((handles()[1].target - Vec2(7, 2)).norm(), 1e-9);
  EXPECT_NEAR(handles()[1].turn->angle, -30, 1e-9);
}

TEST_F(Mirroring, HandlesWithoutAPartnerAreSaid) {
  key(Key::x);
  click(pixel_of({1, 2}));
  set_name(*editor_, "paw");
  key(Key::x, kShift);
  ASSERT_FALSE(editor_->messages().toasts().empty());
  EXPECT_EQ(editor_->messages().toasts().back().text, "No partner in the mirror: paw");
}

TEST_F(Mirroring, TheAxisIsDraggedByItsEndsChosenAndTakenBack) {
  const std::size_t before = steps();
  drag(pixel_of({4, 8}), pixel_of({5, 7}));
  EXPECT_LT((rig().mirror->axis.to - Vec2(5, 7)).norm(), 1e-9);
  EXPECT_EQ(steps(), before + 1);
  press(pixel_of({5, 7}));
  move(pixel_of({6, 6}));
  key(Key::escape);
  EXPECT_LT((rig().mirror->axis.to - Vec2(5, 7)).norm(), 1e-9);
  click(pixel_of({5, 7}));
  EXPECT_EQ(steps(), before + 1) << "a click moves nothing";
  editor_->run_command("mirror.level");
  EXPECT_LT((rig().mirror->axis.from - Vec2(0, 4)).norm(), 1e-9);
  editor_->run_command("mirror.upright");
  EXPECT_LT((rig().mirror->axis.from - Vec2(4, 0)).norm(), 1e-9);
}

TEST_F(Mirroring, IsSavedAndOpenedAgain) {
  const TemporaryFolder folder;
  drag(pixel_of({4, 8}), pixel_of({5, 7}));
  const Rig saved = rig();
  ASSERT_TRUE(editor_->files().save_as(folder / "mirror.json"));
  editor_->files().open(folder / "mirror.json");
  EXPECT_EQ(rig(), saved);
}

}  // namespace
}  // namespace foldless::test
