// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/remesh_diff.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

class RemeshDiffTest : public EditorTest {
 protected:
  RemeshDiffTest() {
    open_grid(5);
    editor_->run_command("view.remesh_diff");
    editor_->view().resize(400, 600, 1);
  }
  const Camera& left() const { return editor_->view().remesh_diff().pane().camera; }
  const Camera& right() const { return editor_->canvas().camera; }
};

TEST_F(RemeshDiffTest, OpensWithBothMeshesAtOneMagnification) {
  EXPECT_TRUE(editor_->view().remesh_diff().is_linked());
  EXPECT_EQ(left().pixels_per_unit, right().pixels_per_unit);
  EXPECT_EQ(editor_->view().remesh_diff().pane().width, 400);
  EXPECT_TRUE(editor_->view().shown_options().layers.remeshed)
      << "flipped edges are what it is about";
  editor_->run_command("view.remesh_diff");
  EXPECT_FALSE(editor_->view().shown_options().layers.remeshed);
}

TEST_F(RemeshDiffTest, LinkedPanesMoveTogetherWhicheverIsMoved) {
  const Camera before = left();
  editor_->view().set_camera(panned(right(), {30, -20}));
  EXPECT_NEAR(left().centre.x, before.centre.x - 30 / before.pixels_per_unit, 1e-12);
  const Camera canvas = right();
  editor_->view().set_rest_camera(zoomed_about(left(), {400, 600}, {200, 300}, 2));
  EXPECT_DOUBLE_EQ(right().pixels_per_unit, 2 * canvas.pixels_per_unit);
  EXPECT_NEAR(right().centre.x, canvas.centre.x, 1e-12);
}

TEST_F(RemeshDiffTest, UnlinkedPanesMoveAlone) {
  key(Key::d, kShift);
  ASSERT_FALSE(editor_->view().remesh_diff().is_linked());
  const Camera canvas = right();
  editor_->view().set_rest_camera(panned(left(), {50, 0}));
  EXPECT_EQ(right(), canvas);
  const Camera pane = left();
  editor_->view().zoom(3);
  EXPECT_EQ(left(), pane);
  key(Key::d, kShift);
  EXPECT_EQ(left().pixels_per_unit, right().pixels_per_unit) << "linking makes the scales one";
  EXPECT_EQ(left().centre, pane.centre) << "but moves nothing";
}

TEST_F(RemeshDiffTest, EditsGoOnBesideIt) {
  place(0);
  place(24);
  drag(pixel_of_handle(1), pixel_of_handle(1) + Vec2(20, 10));
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged) << editor_->status().words;
  EXPECT_TRUE(is_valid());
}

}  // namespace
}  // namespace foldless::test
