// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/draft.h"

#include <gtest/gtest.h>

#include "tests/support/meshes.h"

namespace foldless::test {
namespace {

/// A draft of a grid of its own, without an editor.
class DraftTest : public testing::Test {
 protected:
  DraftTest() {
    Fixture grid = square_grid(4);
    draft_.install(document_of(Shape{std::move(grid.triangles), std::move(grid.rest)}, "grid"),
                   "Open grid");
  }

  Document with_iterations(int count) const {
    Document document = draft_.document();
    document.parameters.inner_iterations = count;
    return document;
  }
  int iterations() const { return draft_.document().parameters.inner_iterations; }
  std::size_t steps() const { return draft_.history().steps().size(); }

  Messages messages_;
  Draft draft_{messages_, {}, std::size_t{1} << 20};
};

TEST_F(DraftTest, AnEditIsOneStepHoweverOftenItChanges) {
  draft_.begin_edit();
  EXPECT_TRUE(draft_.is_editing());
  draft_.apply(with_iterations(5), Change::appearance);
  draft_.apply(with_iterations(6), Change::appearance);
  draft_.commit("Count");
  EXPECT_FALSE(draft_.is_editing());
  EXPECT_EQ(steps(), 2U);
  draft_.undo();
  EXPECT_NE(iterations(), 6);
  draft_.redo();
  EXPECT_EQ(iterations(), 6);
}

TEST_F(DraftTest, AnAbandonedEditLeavesNothing) {
  const Document before = draft_.document();
  draft_.begin_edit();
  draft_.apply(with_iterations(5), Change::appearance);
  draft_.abandon_edit();
  EXPECT_TRUE(is_same_content(draft_.document(), before));
  EXPECT_EQ(steps(), 1U);
}

TEST_F(DraftTest, AnEditThatIsGivenUpEndsTheStepBeforeIt) {
  draft_.edit_again("Count", with_iterations(5), Change::parameters);
  draft_.begin_edit();
  draft_.apply(with_iterations(7), Change::parameters);
  draft_.abandon_edit();
  draft_.edit_again("Count", with_iterations(6), Change::parameters);
  EXPECT_EQ(steps(), 3U);
  draft_.undo();
  EXPECT_EQ(iterations(), 5);
}

TEST_F(DraftTest, EditsOfOneParameterWithinASecondAreOneStep) {
  draft_.edit_again("Count", with_iterations(5), Change::parameters);
  messages_.tick(0.9);
  draft_.edit_again("Count", with_iterations(6), Change::parameters);
  EXPECT_EQ(steps(), 2U);
  messages_.tick(2);
  draft_.edit_again("Count", with_iterations(7), Change::parameters);
  EXPECT_EQ(steps(), 3U);
  draft_.edit_again("Another", with_iterations(8), Change::parameters);
  EXPECT_EQ(steps(), 4U);
}

TEST_F(DraftTest, ASealedStepTakesNoMoreEdits) {
  draft_.edit_again("Count", with_iterations(5), Change::parameters);
  draft_.seal();
  draft_.edit_again("Count", with_iterations(6), Change::parameters);
  EXPECT_EQ(steps(), 3U);
}

TEST_F(DraftTest, UndoInAGestureCancelsTheGestureOnly) {
  draft_.edit("Count", with_iterations(5), Change::appearance);
  bool has_gesture = true;
  draft_.on_interrupt([&] { return std::exchange(has_gesture, false); });
  draft_.undo();
  EXPECT_EQ(iterations(), 5);
  draft_.undo();
  EXPECT_NE(iterations(), 5);
}

TEST_F(DraftTest, AnEditWhileAnIterationIsLookedAtGoesOnFromIt) {
  auto earlier = std::make_shared<Snapshot>(*draft_.document().pose);
  earlier->deformed.col(0) += Vec2(-0.25, -0.25);
  draft_.look_at({3, earlier});
  EXPECT_EQ(draft_.shown(), earlier);
  EXPECT_NE(draft_.document().pose, earlier) << "to look is no edit";
  draft_.begin_edit();
  draft_.commit("Use");
  EXPECT_EQ(draft_.document().pose, earlier);
  EXPECT_FALSE(draft_.look_back());
}

TEST_F(DraftTest, AnotherDocumentHasAHistoryOfItsOwn) {
  draft_.edit("Count", with_iterations(5), Change::appearance);
  draft_.install(empty_document(), "New");
  EXPECT_EQ(steps(), 1U);
  EXPECT_EQ(draft_.shown(), nullptr);
}

}  // namespace
}  // namespace foldless::test
