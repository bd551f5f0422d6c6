// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/history.h"

#include <random>

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

Document grid_document(int n) {
  Fixture grid = square_grid(n);
  return document_of(Shape{std::move(grid.triangles), std::move(grid.rest)}, "grid");
}

TEST(History, PushForgetsWhatWasUndone) {
  History history;
  history.push("a", empty_document());
  history.push("b", empty_document());
  history.jump(1);
  history.push("c", empty_document());
  ASSERT_EQ(history.steps().size(), 3U);
  EXPECT_EQ(history.steps()[2].label, "c");
  EXPECT_FALSE(history.can_redo());
}

TEST(History, KeepsAHundredStepsOfALargeMesh) {
  History history;
  Document document = grid_document(60);
  history.reset("open", document);
  for (int k = 0; k < 120; ++k) {
    auto pose = std::make_shared<Snapshot>(*document.pose);
    pose->deformed.array() += 1;
    document.pose = pose;
    history.push("move", document);
  }
  EXPECT_EQ(history.steps().size(), 121U);
}

/// No step shares positions or triangles with another, as after a drag that flips edges.
TEST(History, AHundredStepsOfTwentyThousandTrianglesTakeLessThan300MB) {
  Document document = grid_document(101);
  ASSERT_GE(document.pose->triangles->cols(), 20'000);
  History history;
  history.reset("open", document);
  for (int k = 0; k < 100; ++k) {
    auto pose = std::make_shared<Snapshot>(*document.pose);
    pose->deformed.array() += 1;
    pose->triangles = std::make_shared<const Triangles>(*pose->triangles);
    document.pose = pose;
    history.push("drag", document);
  }
  EXPECT_EQ(history.steps().size(), 101U);
  EXPECT_LT(history.bytes(), 300'000'000U);
  RecordProperty("bytes", std::to_string(history.bytes()));
}

TEST(History, StaysWithinItsMemoryCap) {
  Document document = grid_document(20);
  History history(100'000);
  history.reset("open", document);
  for (int k = 0; k < 200; ++k) {
    auto pose = std::make_shared<Snapshot>(*document.pose);
    pose->deformed.array() += 1;
    document.pose = pose;
    history.push(std::to_string(k), document);
  }
  EXPECT_LE(history.bytes(), 100'000U);
  EXPECT_GT(history.steps().size(), 2U);
  EXPECT_EQ(history.steps()[history.current()].label, "199");
}

TEST(History, CountsSharedPartsOnce) {
  const Document document = grid_document(30);
  History history;
  history.reset("open", document);
  const std::size_t one = history.bytes();
  for (int k = 0; k < 10; ++k) history.push("same", document);
  EXPECT_LT(history.bytes(), 2 * one);
}

using Undo = EditorTest;

TEST_F(Undo, OneDragIsOneStep) {
  open_grid(6);
  place(0);
  const int id = place(35);
  settle();
  const std::size_t steps = editor_->draft().history().steps().size();
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(40, 30));
  settle();
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  key(Key::z, kControl);
  EXPECT_EQ(editor_->draft().history().current(), steps - 1);
}

TEST_F(Undo, RestoresExactlyAcrossFlips) {
  open_grid(7);
  place(0);
  const int id = place(48);
  settle();
  const Document before = editor_->document();
  const Vec2 from = pixel_of_handle(id);
  // The far corner to the middle of the grid: squashed triangles flip their edges.
  drag(from, pixel_of(Vec2(2.0, 2.5)));
  settle();
  const Document after = editor_->document();
  ASSERT_FALSE(after.pose->flipped_edges->empty()) << "the drag is to flip edges";
  key(Key::z, kControl);
  EXPECT_TRUE(is_same_content(editor_->document(), before));
  EXPECT_TRUE(editor_->shown()->flipped_edges->empty());
  for (int k = 0; k < 5; ++k) frame();
  EXPECT_TRUE(is_same_content(editor_->document(), before)) << "nothing runs after undo";
  key(Key::y, kControl);
  EXPECT_TRUE(is_same_content(editor_->document(), after));
  EXPECT_EQ(editor_->document().pose->revision, after.pose->revision);
}

TEST_F(Undo, KeepsWhatTheSolverReachedWhenAStepIsLeft) {
  open_grid(6);
  place(0);
  const int id = place(35);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(-60, 80));
  settle();
  const Document settled = editor_->document();
  key(Key::z, kControl);
  key(Key::z, kControlShift);
  EXPECT_TRUE(is_same_content(editor_->document(), settled));
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
}

TEST_F(Undo, MeshGoesOnFromWhereUndoLed) {
  open_grid(6);
  place(0);
  const int id = place(35);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(-60, 80));
  settle();
  key(Key::z, kControl);
  const Vec2 again = pixel_of_handle(id);
  drag(again, again + Vec2(30, 0));
  settle();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  EXPECT_TRUE(is_valid());
}

TEST_F(Undo, JumpsToAnyStep) {
  open_grid(5);
  for (const int vertex : {0, 4, 20, 24}) place(vertex);
  editor_->draft().jump_to_step(2);
  EXPECT_EQ(editor_->document().handles.size(), 2U);
  editor_->draft().jump_to_step(4);
  EXPECT_EQ(editor_->document().handles.size(), 4U);
  editor_->draft().jump_to_step(0);
  EXPECT_TRUE(editor_->document().handles.empty());
}

TEST_F(Undo, InTheMiddleOfADragCancelsTheDrag) {
  open_grid(5);
  const int id = place(24);
  const Vec2 before = target(id);
  const Vec2 from = pixel_of_handle(id);
  press(from);
  move(from + Vec2(40, 0));
  frame();
  key(Key::z, kControl);
  EXPECT_FALSE(editor_->draft().is_editing());
  EXPECT_EQ(target(id), before);
  release(from + Vec2(40, 0));
  EXPECT_EQ(editor_->document().handles.size(), 1U);
}

TEST_F(Undo, ResetPoseIsAStepThatComesBack) {
  open_grid(6);
  place(0);
  click(pixel_of(Vec2(2.3, 3.6)));
  const int id = place(35);
  const Vec2 from = pixel_of_handle(id);
  drag(from, from + Vec2(-60, 80));
  settle();
  const Document before = editor_->document();
  key(Key::r, kControl);
  EXPECT_EQ(editor_->document().handles.size(), 3U);
  EXPECT_EQ(*editor_->shown()->rest, editor_->shown()->deformed);
  EXPECT_TRUE(editor_->shown()->flipped_edges->empty());
  for (const Handle& handle : editor_->document().handles)
    EXPECT_EQ(Vec2(editor_->shown()->rest->col(handle.vertex)), handle.target);
  EXPECT_TRUE(is_valid());
  key(Key::z, kControl);
  EXPECT_TRUE(is_same_content(editor_->document(), before));
}

TEST_F(Undo, EveryStepOfARandomSessionComesBackExactly) {
  constexpr unsigned kSeed = 20240607;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> x(100, 700), y(80, 520);
  open_grid(6);
  std::vector<Document> states;
  for (int k = 0; k < 12; ++k) {
    drag(Vec2(x(random), y(random)), Vec2(x(random), y(random)));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    frame();
  }
  editor_->playback().stop();
  while (true) {
    states.push_back(editor_->document());
    if (!editor_->draft().history().can_undo()) break;
    key(Key::z, kControl);
  }
  for (auto state = states.rbegin(); state != states.rend(); ++state) {
    EXPECT_TRUE(is_same_content(editor_->document(), *state));
    EXPECT_TRUE(is_valid());
    key(Key::y, kControl);
  }
}

}  // namespace
}  // namespace foldless::test
