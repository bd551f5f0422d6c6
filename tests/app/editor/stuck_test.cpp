// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/stuck.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// A square whose corner 3 is to pass the diagonal between the corners 0 and 2, which are held: on
/// a fixed triangulation it cannot.
class Stuck : public EditorTest {
 protected:
  Stuck() {
    Fixture square = unit_square();
    editor_->files().open_shape(Shape{std::move(square.triangles), std::move(square.rest)},
                                "square");
    editor_->edits().set_method("paper-noflip");
    for (const int vertex : {0, 1, 2, 3}) place(vertex);
    drag(pixel_of_vertex(3), pixel_of(Vec2(0.7, 0.3)));
    settle();
  }
};

TEST_F(Stuck, NamesTheEdgeInTheWay) {
  ASSERT_EQ(editor_->status().kind, StatusKind::blocked) << editor_->status().words;
  ASSERT_TRUE(editor_->stuck().handle());
  const StuckHandle& stuck = *editor_->stuck().handle();
  EXPECT_EQ(stuck.vertex, 3) << "those that are held are pulled along a little: it is the farthest";
  EXPECT_EQ(stuck.blocking, (std::vector<Edge>{{0, 2}}));
  EXPECT_TRUE(stuck.can_flip);
  EXPECT_TRUE(stuck.can_split);
  ASSERT_TRUE(stuck.stop);
  const Points& deformed = editor_->shown()->deformed;
  EXPECT_NEAR(signed_area(deformed.col(0), deformed.col(2), *stuck.stop), 0, 1e-9)
      << "on the diagonal as it is";
  EXPECT_TRUE(words_of(stuck).starts_with("Vertex 3 is 0.")) << words_of(stuck);
  EXPECT_NE(words_of(stuck).find("1 edge stands in its way"), std::string::npos);
}

TEST_F(Stuck, FlippingLetsItThroughAndIsOneUndoStep) {
  const Points before = editor_->shown()->deformed;
  const Triangles triangles = *editor_->shown()->triangles;
  key(Key::f, kShift);
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged) << editor_->status().words;
  EXPECT_TRUE(editor_->stuck().handles().empty());
  EXPECT_TRUE(is_valid());
  EXPECT_EQ(editor_->shown()->flipped_edges->size(), 1U);
  editor_->draft().undo();
  EXPECT_EQ(editor_->shown()->deformed, before);
  EXPECT_EQ(*editor_->shown()->triangles, triangles);
}

TEST_F(Stuck, SplittingMakesVerticesAndKeepsTheMapValid) {
  key(Key::s, kShift);
  settle();
  EXPECT_GT(editor_->shown()->rest->cols(), 4);
  EXPECT_EQ(editor_->shown()->original_vertices, 4);
  EXPECT_TRUE(is_valid());
  EXPECT_LT(editor_->status().residual, 0.3) << "nearer than the diagonal";
  editor_->draft().undo();
  EXPECT_EQ(editor_->shown()->rest->cols(), 4);
}

TEST_F(Stuck, IsToldOnlyWhileItRestsAndIsAskedFor) {
  ASSERT_TRUE(editor_->stuck().handle());
  key(Key::w);
  frame();
  EXPECT_FALSE(editor_->stuck().handle());
  key(Key::w);
  frame();
  EXPECT_TRUE(editor_->stuck().handle());
  EXPECT_FALSE(frame()) << "and costs nothing from then on";
  press(pixel_of_handle(3));
  move(pixel_of_handle(3) + Vec2(-30, -30));
  frame();
  EXPECT_FALSE(editor_->stuck().handle()) << "it moves again";
}

TEST_F(Stuck, ASelectedHandleIsToldOfFirst) {
  ASSERT_GE(editor_->stuck().handles().size(), 2U);
  for (const StuckHandle& handle : editor_->stuck().handles()) {
    editor_->selection().select({handle.id});
    EXPECT_EQ(editor_->stuck().handle()->id, handle.id);
  }
}

TEST(FindStuckHandles, SaysWhenItsOwnTrianglesAreNotTheReason) {
  Fixture grid = square_grid(5);
  Document document = document_of(Shape{grid.triangles, grid.rest}, "grid");
  Handle handle;
  handle.vertex = 12;
  handle.target = Vec2(2.1, 2.05);
  document.handles = {handle};
  const auto stuck = find_stuck_handles(document);
  ASSERT_EQ(stuck.size(), 1U);
  EXPECT_FALSE(stuck.front().stop);
  EXPECT_NE(words_of(stuck.front()).find("the mesh between the handles"), std::string::npos);
}

TEST(FindStuckHandles, LeavesSoftHandlesAndThoseAtTheirTargetsAlone) {
  Fixture grid = square_grid(5);
  Document document = document_of(Shape{grid.triangles, grid.rest}, "grid");
  Handle soft, reached;
  soft.kind = HandleKind::soft;
  soft.target = Vec2(9, 9);
  reached.vertex = 7;
  reached.id = 1;
  reached.target = grid.rest.col(7);
  document.handles = {soft, reached};
  EXPECT_TRUE(find_stuck_handles(document).empty());
  EXPECT_FALSE(with_blocking_flipped(document, 5)) << "no such handle";
}

}  // namespace
}  // namespace foldless::test
