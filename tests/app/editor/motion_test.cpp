// SPDX-License-Identifier: GPL-3.0-or-later
// The time line without its window: frames and the play head.
#include "app/editor/motion.h"

#include "app/editor/handle_edits.h"
#include "tests/app/editor/motion_fixture.h"

namespace foldless::test {
namespace {

constexpr Modifiers kAlt{.alt = true};

TEST_F(EditorMotion, ShowsTheFrameAtThePlayHeadAndItsTargets) {
  animate();
  const auto frames = &motion().frames();
  for (const int f : {3, 11, 0, 8, 5}) {
    motion().play_head().go_to(f);
    frame();
    EXPECT_EQ(editor_->shown()->deformed, frames->frame(f)->snapshot->deformed) << f;
    const auto expected = handles_at(animation(), editor_->document().handles, f);
    for (const Handle& handle : editor_->shown()->handles)
      for (const Handle& other : expected)
        if (other.id == handle.id) {
          EXPECT_EQ(other.target, handle.target);
        }
    EXPECT_TRUE(is_injective(*editor_->shown()->triangles, *editor_->shown()->rest,
                             editor_->shown()->deformed));
    EXPECT_TRUE(editor_->draft().proof().holds());
  }
}

TEST_F(EditorMotion, MovingAKeySolvesOnlyWhatFollowsIt) {
  animate();
  motion().play_head().go_to(11);
  frame();
  drag_handle(ids_[2], {30, 0});
  solve_all();
  std::vector<std::shared_ptr<const SolvedFrame>> before;
  for (int f = 0; f < 12; ++f) before.push_back(motion().frames().frame(f));
  motion().keys().select({{ids_[2], KeyedProperty::position, 11}});
  motion().keys().move_selected([](int f) { return f - 1; }, false);
  solve_all();
  for (int f = 0; f <= 8; ++f) EXPECT_EQ(motion().frames().frame(f)->snapshot, before[f]->snapshot);
  EXPECT_NE(motion().frames().frame(10)->snapshot->deformed, before[10]->snapshot->deformed);
}

TEST_F(EditorMotion, NamesAndDepthsSolveNothing) {
  animate();
  const auto before = motion().frames().frame(8);
  editor_->selection().select({ids_[2]});
  set_name(*editor_, "hand");
  set_depth(*editor_, 3);
  frame();
  EXPECT_TRUE(motion().frames().status().is_done);
  EXPECT_EQ(motion().frames().frame(8), before);
  motion().play_head().go_to(3);
  frame();
  const auto& handles = editor_->shown()->handles;
  const auto hand = std::find_if(handles.begin(), handles.end(),
                                 [&](const Handle& h) { return h.id == ids_[2]; });
  EXPECT_EQ(hand->name, "hand");
}

TEST_F(EditorMotion, PlaysAtItsFrameRateAndBeginsAnew) {
  animate();
  motion().keys().set_fps(60);
  motion().play_head().go_to(0);
  key(Key::space);
  ASSERT_TRUE(motion().play_head().is_playing());
  EXPECT_TRUE(editor_->next_wake());
  for (int f = 1; f <= 14; ++f) {
    frame();
    EXPECT_EQ(motion().play_head().frame(), f % 12);
  }
  key(Key::space);
  EXPECT_FALSE(motion().play_head().is_playing());
  const int stays = motion().play_head().frame();
  frame();
  EXPECT_EQ(motion().play_head().frame(), stays);
}

TEST_F(EditorMotion, KeysOfTheKeyboardMoveThePlayHead) {
  animate();
  motion().play_head().go_to(0);
  key(Key::period);
  EXPECT_EQ(motion().play_head().frame(), 1);
  key(Key::comma);
  key(Key::comma);
  EXPECT_EQ(motion().play_head().frame(), 11) << "round the end";
  key(Key::comma, kShift);
  EXPECT_EQ(motion().play_head().frame(), 0);
  key(Key::period, kAlt);
  EXPECT_EQ(motion().play_head().frame(), 8);
  key(Key::comma, kAlt);
  EXPECT_EQ(motion().play_head().frame(), 0);
  key(Key::period, kShift);
  EXPECT_EQ(motion().play_head().frame(), 11);
}

TEST_F(EditorMotion, OutlinesAreOfTheKeysBeforeAndAfter) {
  animate();
  motion().play_head().go_to(4);
  frame();
  EXPECT_TRUE(motion().neighbours().empty());
  key(Key::u);
  const auto poses = motion().neighbours();
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0], motion().frames().frame(0)->snapshot);
  EXPECT_EQ(poses[1], motion().frames().frame(8)->snapshot);
}

TEST_F(EditorMotion, TellsOfFramesThatAreNotReached) {
  animate();
  EXPECT_EQ(editor_->status().kind, StatusKind::converged);
  Document document = editor_->document();
  document.parameters.method = "paper";
  document.parameters.alpha = 1e-6;  // handles pull hardly
  editor_->draft().edit("Weak handles", document, Change::appearance);
  solve_all();
  EXPECT_EQ(editor_->status().kind, StatusKind::blocked) << editor_->status().words;
  EXPECT_TRUE(editor_->draft().proof().holds());
}

/// A whole turn, which twists the mesh round it, and no turn in frame 0, where it comes back to.
class EditorMotionOfATurn : public EditorMotion {
 protected:
  void turn_the_middle_once_in_a_loop() {
    const int middle = place(40);
    solve_all();
    editor_->draft().take_over_look_back();  // as every edit of handles does
    Document document = editor_->document();
    std::ranges::find(document.handles, middle, &Handle::id)->turn = Turn{0, 1.5};
    HandleTracks tracks;
    tracks.handle = middle;
    tracks.angle = {{0, 0, {}}, {12, 360, {}}};
    Animation animation;
    animation.cycle = {12, true};
    animation.tracks = {tracks};
    document.animation = std::make_shared<const Animation>(animation);
    editor_->draft().edit("Turn", document, Change::mesh);
    solve_all();
  }
};

TEST_F(EditorMotionOfATurn, TheStatusSaysByHowMuchALoopDoesNotClose) {
  animate();
  motion().keys().set_cycle({12, true});
  solve_all();
  ASSERT_TRUE(motion().frames().status().gap);
  EXPECT_FALSE(motion().gap()) << "it closes";
  EXPECT_EQ(editor_->status().words.find("the loop comes back"), std::string::npos);
  turn_the_middle_once_in_a_loop();
  ASSERT_TRUE(motion().gap());
  EXPECT_NEAR(*motion().gap(), *motion().frames().status().gap * 1024 / 8, 1e-9)
      << "in pixels, of which the grid of side 8 has 1024";
  std::array<char, 64> words{};
  std::snprintf(words.data(), words.size(), "the loop comes back only to within %.3g px",
                *motion().gap());
  EXPECT_NE(editor_->status().words.find(words.data()), std::string::npos)
      << editor_->status().words;
}

TEST_F(EditorMotion, ClosedItShowsTheNewestStateAndSetsNoKeys) {
  animate();
  key(Key::t);
  EXPECT_FALSE(motion().is_open());
  EXPECT_FALSE(editor_->draft().look_back());
  const Keys keys = keys_of(animation());
  drag_handle(ids_[1], {10, 10});
  EXPECT_EQ(keys_of(animation()), keys);
}

}  // namespace
}  // namespace foldless::test
