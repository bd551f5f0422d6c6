// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/side_pane.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

class SidePanes : public EditorTest {
 protected:
  SidePanes() {
    open_grid(5);
    editor_->run_command("view.remesh_diff");
    editor_->view().resize(400, 600, 1);
  }
  const Camera& left() const { return editor_->view().side_pane().pane().camera; }
  const Camera& right() const { return editor_->canvas().camera; }
};

TEST_F(SidePanes, OpensWithBothMeshesAtOneMagnification) {
  EXPECT_TRUE(editor_->view().side_pane().is_linked());
  EXPECT_EQ(left().pixels_per_unit, right().pixels_per_unit);
  EXPECT_EQ(editor_->view().side_pane().pane().width, 400);
  EXPECT_TRUE(editor_->view().shown_options().layers.remeshed)
      << "flipped edges are what it is about";
  editor_->run_command("view.remesh_diff");
  EXPECT_FALSE(editor_->view().shown_options().layers.remeshed);
}

TEST_F(SidePanes, LinkedPanesMoveTogetherWhicheverIsMoved) {
  const Camera before = left();
  editor_->view().set_camera(panned(right(), {30, -20}));
  EXPECT_NEAR(left().centre.x, before.centre.x - 30 / before.pixels_per_unit, 1e-12);
  const Camera canvas = right();
  editor_->view().set_side_camera(zoomed_about(left(), {400, 600}, {200, 300}, 2));
  EXPECT_DOUBLE_EQ(right().pixels_per_unit, 2 * canvas.pixels_per_unit);
  EXPECT_NEAR(right().centre.x, canvas.centre.x, 1e-12);
}

TEST_F(SidePanes, UnlinkedPanesMoveAlone) {
  key(Key::d, kShift);
  ASSERT_FALSE(editor_->view().side_pane().is_linked());
  const Camera canvas = right();
  editor_->view().set_side_camera(panned(left(), {50, 0}));
  EXPECT_EQ(right(), canvas);
  const Camera pane = left();
  editor_->view().zoom(3);
  EXPECT_EQ(left(), pane);
  key(Key::d, kShift);
  EXPECT_EQ(left().pixels_per_unit, right().pixels_per_unit) << "linking makes the scales one";
  EXPECT_EQ(left().centre, pane.centre) << "but moves nothing";
}

TEST_F(SidePanes, EditsGoOnBesideIt) {
  place(0);
  place(24);
  drag(pixel_of_handle(1), pixel_of_handle(1) + Vec2(20, 10));
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged) << editor_->status().words;
  EXPECT_TRUE(is_valid());
}

class PosePanes : public EditorTest {
 protected:
  PosePanes() {
    open_grid(5);
    place(0);
    id_ = place(24);
    settle();
  }
  void pull() {
    drag(pixel_of_handle(id_), pixel_of_handle(id_) + Vec2(-40, 60));
    settle();
  }
  Beside beside() const { return editor_->view().beside(); }
  const Camera& left() const { return editor_->view().side_pane().pane().camera; }
  const Camera& right() const { return editor_->canvas().camera; }

  int id_ = 0;
};

TEST_F(PosePanes, TheFirstTimeThePoseOnScreenIsKept) {
  const Points before = editor_->shown()->deformed;
  key(Key::backslash, kControl);
  ASSERT_EQ(beside(), Beside::kept_pose);
  pull();
  EXPECT_EQ(editor_->comparison().kept()->deformed, before);
  EXPECT_NE(editor_->shown()->deformed, before);
  key(Key::backslash, kControl);
  EXPECT_EQ(beside(), Beside::nothing);
  key(Key::backslash, kControl);
  EXPECT_EQ(editor_->comparison().kept()->deformed, before) << "kept until another one is";
}

TEST_F(PosePanes, ShowTheSamePartOfThePlaneWithBothPosesWhole) {
  drag(pixel_of_handle(id_), pixel_of_handle(id_) + Vec2(250, 0));
  settle();
  key(Key::backslash, kShift);
  editor_->edits().reset_pose();
  key(Key::backslash, kControl);
  editor_->view().resize(400, 600, 1);
  EXPECT_EQ(left(), right());
  const Canvas& pane = editor_->view().side_pane().pane();
  for (const Points* points :
       {&editor_->comparison().kept()->deformed, &editor_->shown()->deformed})
    for (const auto& point : points->colwise()) {
      const Vec2 pixel = pane.to_pixel(point);
      EXPECT_TRUE((PixelBox{{0, 0}, {400, 600}}.contains(pixel))) << pixel.transpose();
    }
  editor_->view().set_side_camera(zoomed_about(left(), {400, 600}, {100, 100}, 2));
  EXPECT_NEAR(left().centre.x, right().centre.x, 1e-9);
  EXPECT_EQ(left().pixels_per_unit, right().pixels_per_unit);
}

TEST_F(PosePanes, TheRestMeshTakesTheirPlaceAtItsOwn) {
  key(Key::backslash, kControl);
  editor_->view().resize(400, 600, 1);
  editor_->view().set_camera({{100, 100}, 7});
  key(Key::d);
  EXPECT_EQ(beside(), Beside::rest_mesh);
  EXPECT_NE(right().pixels_per_unit, 7) << "it is fitted";
  EXPECT_TRUE(editor_->view().shown_options().layers.remeshed);
  key(Key::backslash, kControl);
  EXPECT_EQ(beside(), Beside::kept_pose);
  EXPECT_EQ(left(), right());
  EXPECT_FALSE(editor_->view().shown_options().layers.remeshed);
}

TEST_F(PosePanes, EscapeEndsThemBeforeItDeselects) {
  key(Key::backslash, kControl);
  editor_->selection().select({id_});
  key(Key::escape);
  EXPECT_EQ(beside(), Beside::nothing);
  EXPECT_FALSE(editor_->selection().ids().empty());
}

TEST_F(PosePanes, GoWithTheKeptPoseAndDoNotComeBackByThemselves) {
  key(Key::backslash, kControl);
  EXPECT_TRUE(editor_->run_command("compare.forget"));
  EXPECT_EQ(beside(), Beside::nothing);
  editor_->view().resize(400, 600, 1);  // as in every frame
  key(Key::backslash, kShift);
  EXPECT_EQ(beside(), Beside::nothing);
  key(Key::backslash, kControl);
  open_grid(4);
  EXPECT_EQ(beside(), Beside::nothing) << "it was of another mesh";
}

}  // namespace
}  // namespace foldless::test
