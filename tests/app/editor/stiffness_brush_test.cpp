// SPDX-License-Identifier: GPL-3.0-or-later
// The stiffness brush, by pointer and keys.
#include "app/editor/stiffness_brush.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// Over a grid of side 8.
class Brush : public EditorTest {
 protected:
  Brush() {
    open_grid(9);
    editor_->brush().set_radius(30);
  }

  const std::shared_ptr<const Stiffness>& stiffness() const {
    return editor_->document().stiffness;
  }
  std::size_t steps() const { return editor_->draft().history().steps().size(); }
  /// Along the middle row, from the left to the middle.
  void paint(Modifiers modifiers = {}) {
    drag(pixel_of_vertex(36), pixel_of_vertex(40), modifiers);
  }
};

TEST_F(Brush, BTakesItAndWhatIsUnderItBecomesStiff) {
  const std::size_t before = steps();
  key(Key::b);
  ASSERT_TRUE(editor_->brush().is_on());
  paint();
  ASSERT_TRUE(stiffness());
  EXPECT_EQ(steps(), before + 1);
  EXPECT_TRUE(editor_->document().handles.empty()) << "a press paints and places nothing";
  EXPECT_EQ(stiffness()->at({2.5, 4}), 100);
  EXPECT_EQ(stiffness()->at({6.5, 4}), 1);
  EXPECT_EQ(stiffness()->at({2.5, 7.5}), 1);
  key(Key::z, kControl);
  EXPECT_FALSE(stiffness());
  key(Key::z, kControlShift);
  EXPECT_TRUE(stiffness());
}

TEST_F(Brush, PaintsWhatIsUnderItWhereTheMeshIsDeformed) {
  place(0);
  place(8);
  const int id = place(80);
  drag(pixel_of_handle(id), pixel_of_handle(id) + Vec2(60, 90));
  settle();
  key(Key::b);
  const Vec2 over_a_vertex = pixel_of_vertex(70);  // inside: no rounding leads off the mesh
  ASSERT_GT((over_a_vertex - pixel_of(editor_->document().pose->rest->col(70))).norm(), 40);
  editor_->brush().set_radius(4);
  click(over_a_vertex);
  ASSERT_TRUE(stiffness());
  EXPECT_EQ(stiffness()->at(editor_->document().pose->rest->col(70)), 100);
}

TEST_F(Brush, WithShiftItTakesBack) {
  key(Key::b);
  paint();
  paint(kShift);
  ASSERT_TRUE(stiffness());
  EXPECT_EQ(stiffness()->at({2.5, 4}), 1);
  EXPECT_EQ(editor_->draft().history().steps().back().label, "Unpaint stiffness");
}

TEST_F(Brush, EscTakesTheStrokeBackAndThenPutsItAway) {
  key(Key::b);
  press(pixel_of_vertex(36));
  move(pixel_of_vertex(38));
  EXPECT_FALSE(editor_->brush().factors().empty()) << "seen while it is painted";
  key(Key::escape);
  release(pixel_of_vertex(38));
  EXPECT_FALSE(stiffness());
  EXPECT_TRUE(editor_->brush().factors().empty());
  EXPECT_TRUE(editor_->brush().is_on());
  key(Key::escape);
  EXPECT_FALSE(editor_->brush().is_on());
  place(40);
  EXPECT_EQ(editor_->document().handles.size(), 1U);
}

TEST_F(Brush, BracketsChangeItsSizeAndDepthsWithoutIt) {
  const int id = place(40);
  key(Key::b);
  key(Key::right_bracket);
  EXPECT_GT(editor_->brush().radius(), 30);
  key(Key::left_bracket);
  EXPECT_NEAR(editor_->brush().radius(), 30, 1e-9);
  EXPECT_EQ(find_handle(editor_->document(), id)->depth, 0);
  key(Key::b);
  key(Key::right_bracket);
  EXPECT_GT(find_handle(editor_->document(), id)->depth, 0);
}

TEST_F(Brush, NothingIsPaintedBesideTheMesh) {
  key(Key::b);
  const std::size_t before = steps();
  drag({3, 3}, {20, 10});
  EXPECT_FALSE(stiffness());
  EXPECT_EQ(steps(), before);
}

TEST_F(Brush, AStrokeThatLeavesTheMeshAndComesBackIsTwoLines) {
  key(Key::b);
  press(pixel_of({4, 7.5}));
  for (const Vec2& at : {Vec2(4, 9.5), Vec2(8.5, 9.5), Vec2(9.5, 4)}) move(pixel_of(at));
  move(pixel_of({7.5, 4}));
  release(pixel_of({7.5, 4}));
  ASSERT_TRUE(stiffness());
  EXPECT_EQ(stiffness()->strokes().size(), 2U);
  EXPECT_EQ(stiffness()->at({5.75, 5.75}), 1) << "not across";
}

TEST_F(Brush, AStiffPartKeepsItsShapeAndTheSolverGoesOnAtOnce) {
  place(0);
  place(72);
  const int id = place(44);
  drag(pixel_of_handle(id), pixel_of_handle(id) + Vec2(-150, 150));
  settle();
  const Snapshot soft = *editor_->document().pose;
  key(Key::b);
  paint();
  settle();
  EXPECT_TRUE(is_valid());
  const auto stretch = [](const Snapshot& pose) {
    return std::abs((pose.deformed.col(40) - pose.deformed.col(36)).norm() - 4);
  };
  EXPECT_LT(stretch(*editor_->document().pose), 0.5 * stretch(soft));
}

TEST_F(Brush, AllOfItIsRemovedByACommand) {
  EXPECT_FALSE(editor_->run_command("stiffness.clear"));
  key(Key::b);
  paint();
  EXPECT_TRUE(editor_->run_command("stiffness.clear"));
  EXPECT_FALSE(stiffness());
  EXPECT_FALSE(editor_->run_command("stiffness.clear"));
}

TEST_F(Brush, ItsNumbersStayWithinTheirRanges) {
  StiffnessBrush& brush = editor_->brush();
  brush.set_factor(1e9);
  EXPECT_EQ(brush.factor(), StiffnessBrush::kLargestFactor);
  brush.set_factor(std::nan(""));
  EXPECT_EQ(brush.factor(), StiffnessBrush::kLargestFactor);
  brush.set_radius(0);
  EXPECT_EQ(brush.radius(), StiffnessBrush::kLeastRadius);
}

TEST_F(Brush, StiffnessIsSavedAndComesBack) {
  key(Key::b);
  paint();
  const TemporaryFolder folder;
  editor_->files().save_as(folder / "stiff.json");
  const Document saved = editor_->document();
  editor_->files().new_document();
  editor_->files().open(folder / "stiff.json");
  ASSERT_TRUE(stiffness());
  EXPECT_EQ(*stiffness(), *saved.stiffness);
}

}  // namespace
}  // namespace foldless::test
