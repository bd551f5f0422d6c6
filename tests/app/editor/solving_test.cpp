// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

/// A grid held at one corner; the opposite corner is handle 1.
class Solving : public EditorTest {
 protected:
  Solving() {
    open_grid(6);
    place(0);
    place(35);
    settle();
  }

  void drag_corner(const Vec2& by) {
    const Vec2 from = pixel_of_handle(1);
    drag(from, from + by);
  }
};

TEST_F(Solving, StatusIsInWords) {
  EXPECT_EQ(editor_->status().words, "Converged");
  editor_->files().new_document();
  editor_->files().answer(Answer::discard);
  EXPECT_EQ(editor_->status().kind, StatusKind::empty);
  open_grid(3);
  EXPECT_EQ(editor_->status().kind, StatusKind::ready);
}

TEST_F(Solving, SaysHowFarItIs) {
  editor_->edits().set_method("paper-flip");
  editor_->playback().set_pace(4);
  drag_corner({-50, 60});
  wait_for([&] {
    return !editor_->playback().iterations().empty() || !editor_->playback().is_solving();
  });
  ASSERT_TRUE(editor_->playback().is_solving())
      << "four iterations a second are slow enough to look";
  EXPECT_EQ(editor_->status().kind, StatusKind::solving);
  EXPECT_TRUE(editor_->status().words.starts_with("Solving ")) << editor_->status().words;
  EXPECT_TRUE(editor_->status().words.ends_with("/1000")) << editor_->status().words;
  EXPECT_GT(editor_->status().residual, 0);
}

TEST_F(Solving, SaysThatACoarserMeshIsSolvedFirst) {
  open_grid(90);  // dense for foldless
  key(Key::space);
  editor_->edits().set_method("paper-flip");
  place(0);
  place(8099);
  place(4040);  // two alone would move by a similarity
  drag_corner({-50, 60});
  key(Key::period);
  wait_for([&] { return !editor_->playback().iterations().empty(); });
  editor_->edits().set_method(
      "foldless");  // begins with handles that are not at their targets: no drag
  key(Key::period);
  wait_for([&] {
    return !editor_->playback().iterations().empty() &&
           editor_->playback().iterations().back().phase == Phase::coarse;
  });
  editor_->playback().set_pace(4);
  key(Key::space);
  EXPECT_EQ(editor_->status().kind, StatusKind::solving);
  EXPECT_EQ(editor_->status().words, "Solving on a coarser mesh first, step 1");
  EXPECT_TRUE(is_valid());
}

TEST_F(Solving, HandlesThatCannotGetThereAreBlocked) {
  Shape shape{Triangles(3, 1), Points(2, 3)};
  shape.triangles << 0, 1, 2;
  shape.rest << 0, 1, 0, 0, 0, 1;
  editor_->files().open_shape(std::move(shape), "triangle");
  editor_->edits().set_method("paper-flip");  // without splits
  for (const int vertex : {0, 1, 2}) place(vertex);
  const Vec2 from = pixel_of_vertex(2);
  drag(from, pixel_of(Vec2(0, -1)));  // would turn the triangle over
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::blocked) << editor_->status().words;
  EXPECT_GT(editor_->status().residual, 0.1);
  EXPECT_EQ(editor_->draft().proof().inverted, 0);
  EXPECT_TRUE(is_valid());
}

TEST_F(Solving, SaysThatHandlesAreLockedWhileFoldlessSplitsEdgesOrTriesAWayRound) {
  editor_->edits().set_method("foldless");
  for (const int vertex : {14, 15}) place(vertex);
  settle();
  editor_->playback().set_pace(60);
  drag(pixel_of_vertex(15), pixel_of_vertex(14));  // no room for both
  const auto says_so = [&] {
    return editor_->status().words.find("handles are locked") != std::string::npos;
  };
  wait_for([&] { return says_so() || !editor_->playback().is_solving(); });
  EXPECT_TRUE(says_so()) << editor_->status().words;
  EXPECT_EQ(editor_->status().kind, StatusKind::solving);
  EXPECT_TRUE(is_valid());
}

TEST_F(Solving, SaysWhyTargetsCannotBeReachedWhereTheWholeBoundaryIsHeld) {
  Shape shape{Triangles(3, 1), Points(2, 3)};
  shape.triangles << 0, 1, 2;
  shape.rest << 0, 1, 0, 0, 0, 1;
  editor_->files().open_shape(std::move(shape), "triangle");
  editor_->edits().set_method("foldless");
  for (const int vertex : {0, 1, 2}) place(vertex);
  settle();
  const Vec2 home = pixel_of_vertex(2), away = pixel_of(Vec2(0, -1));
  drag(home, away);  // would turn the triangle over
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::blocked);
  EXPECT_EQ(editor_->status().words,
            "Infeasible: the held boundary with vertex 0 is to go the wrong way round");
  EXPECT_TRUE(is_valid());
  drag(away, home);
  settle();
  EXPECT_EQ(editor_->status().words, "Converged");
}

TEST_F(Solving, SpaceTapPausesAndResumes) {
  key(Key::space);
  EXPECT_EQ(editor_->status().kind, StatusKind::converged) << "nothing is left to do";
  EXPECT_EQ(editor_->status().words, "Converged (paused)");
  EXPECT_EQ(editor_->playback().state(), SolvingState::paused);
  drag_corner({-50, 60});
  for (int k = 0; k < 10; ++k) frame();
  EXPECT_EQ(editor_->status().words, "Paused");
  EXPECT_TRUE(editor_->playback().iterations().empty());
  key(Key::space);
  settle();
  EXPECT_EQ(editor_->status().words, "Converged");
}

TEST_F(Solving, PeriodDoesOneIteration) {
  key(Key::space);
  drag_corner({-50, 60});
  for (std::size_t k = 1; k <= 3; ++k) {
    key(Key::period);
    wait_for([&] { return editor_->playback().iterations().size() >= k; });
    for (int f = 0; f < 5; ++f) frame();
    EXPECT_EQ(editor_->playback().iterations().size(), k);
    EXPECT_EQ(editor_->playback().state(), SolvingState::paused);
  }
}

TEST_F(Solving, EscapeStopsThenDeselects) {
  editor_->playback().set_pace(2);
  drag_corner({-80, 60});
  frame();
  ASSERT_TRUE(editor_->playback().is_solving());
  key(Key::escape);
  EXPECT_EQ(editor_->status().kind, StatusKind::stopped);
  EXPECT_FALSE(editor_->selection().ids().empty());
  key(Key::escape);
  EXPECT_TRUE(editor_->selection().ids().empty());
  editor_->playback().set_pace(std::nullopt);
  key(Key::space);
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
}

TEST_F(Solving, TimelineBeginsWithTheDrag) {
  drag_corner({-50, 60});
  settle();
  ASSERT_FALSE(editor_->playback().iterations().empty());
  const double energy = editor_->playback().iterations().back().energy;
  drag_corner({5, 0});
  EXPECT_TRUE(editor_->playback().iterations().empty() ||
              editor_->playback().iterations().front().energy != energy);
}

TEST_F(Solving, TimelineCanBeScrubbed) {
  drag_corner({-90, 110});
  settle();
  const std::size_t count = editor_->playback().iterations().size();
  ASSERT_GE(count, 3U);
  const auto newest = editor_->shown();
  key(Key::comma);
  EXPECT_EQ(editor_->playback().scrubbed(), count - 2);
  key(Key::comma, kShift);
  EXPECT_EQ(editor_->playback().scrubbed(), 0U);
  EXPECT_NE(editor_->shown()->deformed, newest->deformed);
  EXPECT_TRUE(is_valid());
  key(Key::period);
  EXPECT_EQ(editor_->playback().scrubbed(), 1U);
  key(Key::period, kShift);
  EXPECT_FALSE(editor_->playback().scrubbed().has_value());
  EXPECT_EQ(editor_->shown()->deformed, newest->deformed);
}

TEST_F(Solving, UseThisIterationIsAnUndoStep) {
  drag_corner({-90, 110});
  settle();
  const Document settled = editor_->document();
  editor_->playback().scrub(0);
  const Points shown = editor_->shown()->deformed;
  key(Key::enter);
  EXPECT_EQ(editor_->document().pose->deformed, shown);
  EXPECT_FALSE(editor_->playback().scrubbed().has_value());
  key(Key::z, kControl);
  EXPECT_TRUE(is_same_content(editor_->document(), settled));
}

TEST_F(Solving, AnEditOfAnOldIterationBeginsThere) {
  drag_corner({-90, 110});
  settle();
  const Document settled = editor_->document();
  editor_->playback().scrub(0);
  const Points shown = editor_->shown()->deformed;
  key(Key::space);  // leaves the timeline and pauses
  editor_->playback().scrub(0);
  place(14);
  EXPECT_EQ(editor_->document().pose->deformed, shown);
  key(Key::z, kControl);
  EXPECT_TRUE(is_same_content(editor_->document(), settled));
}

TEST_F(Solving, SnapshotsOfAnOlderMeshAreNotTaken) {
  for (int k = 0; k < 30; ++k) {
    drag_corner({k % 2 ? 40.0 : -40.0, 10});
    click(pixel_of(Vec2(1.3 + 0.05 * k, 2.6)));
    const auto vertices = editor_->shown()->deformed.cols();
    for (int f = 0; f < 3; ++f) frame();
    ASSERT_EQ(editor_->shown()->deformed.cols(), vertices);
    ASSERT_TRUE(is_valid());
    key(Key::z, kControl);
    const Document restored = editor_->document();
    for (int f = 0; f < 3; ++f) frame();
    ASSERT_TRUE(is_same_content(editor_->document(), restored));
    settle();
  }
}

TEST_F(Solving, EnergyAndParametersAreSteps) {
  drag_corner({-50, 60});
  settle();
  const std::size_t steps = editor_->draft().history().steps().size();
  editor_->edits().set_parameter(*find_parameter_row("alpha"), 1e6);
  editor_->edits().set_parameter(*find_parameter_row("alpha"), 1e7);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1) << "one slider, one step";
  now_ += 2;
  editor_->update(now_);
  editor_->edits().set_parameter(*find_parameter_row("alpha"), 1e8);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 2);
  EXPECT_EQ(editor_->document().parameters.alpha, 1e8);
  key(Key::z, kControl);
  EXPECT_EQ(editor_->document().parameters.alpha, 1e7);
  key(Key::z, kControl);
  EXPECT_EQ(editor_->document().parameters, Parameters{});
}

TEST_F(Solving, PaceIsHeldBetweenOneAndSixty) {
  editor_->playback().set_pace(1e9);
  EXPECT_EQ(editor_->playback().pace(), 60);
  editor_->playback().set_pace(0.001);
  EXPECT_EQ(editor_->playback().pace(), 1);
}

TEST_F(Solving, IdleNeedsNoFrames) {
  settle();
  frame();
  for (int k = 0; k < 20; ++k) EXPECT_FALSE(frame());
  EXPECT_FALSE(editor_->next_wake().has_value());
}

TEST_F(Solving, ProofIsOfTheMeshOnScreen) {
  EXPECT_EQ(editor_->draft().proof().inverted, 0);
  EXPECT_NEAR(editor_->draft().proof().min_area_ratio, 1, 1e-6);
  drag_corner({-90, 110});
  settle();
  EXPECT_EQ(editor_->draft().proof().inverted, 0);
  EXPECT_LT(editor_->draft().proof().min_area_ratio, 0.999);
  EXPECT_GT(editor_->draft().proof().min_area_ratio, 0);
}

}  // namespace
}  // namespace foldless::test
