// SPDX-License-Identifier: GPL-3.0-or-later
// The time line without its window.
#include "app/editor/motion.h"

#include "app/editor/handle_edits.h"
#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

constexpr Modifiers kAlt{.alt = true};

/// A grid that is held in three places, with the time line open and twelve frames.
class EditorMotion : public EditorTest {
 protected:
  void SetUp() override {
    EditorTest::SetUp();
    open_grid(9);
    for (const int vertex : {0, 8, 76}) ids_.push_back(place(vertex));
    settle();
    key(Key::t);
    ASSERT_EQ(editor_->document().handles.size(), 3U);
    motion().set_cycle({12, false});
    frame();
  }

  Motion& motion() { return editor_->motion(); }
  const Animation& animation() { return motion().animation(); }
  /// Drags a handle as a person does, in the canvas.
  void drag_handle(int id, const Vec2& by) {
    const Vec2 from = pixel_of(shown_at(id));
    drag(from, from + by);
    frame();
  }
  Vec2 shown_at(int id) {
    const int vertex = find_handle(editor_->document(), id)->vertex;
    return editor_->shown()->deformed.col(vertex);
  }
  void solve_all() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    frame();
    while (!motion().frames().status().is_done) {
      ASSERT_LT(std::chrono::steady_clock::now(), give_up) << motion().frames().status().error;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      frame();
    }
    frame();
  }
  /// A handle that goes up from frame 0 to frame 8.
  void animate() {
    motion().go_to(8);
    frame();
    drag_handle(ids_[2], {0, -40});
    solve_all();
  }
  std::vector<int> key_frames() {
    std::vector<int> frames;
    for (const KeyPlace& key : keys_of(animation())) frames.push_back(key.frame);
    return frames;
  }

  std::vector<int> ids_;
};

TEST_F(EditorMotion, AMovedHandleGetsAKeyAndOneAtTheStart) {
  const Vec2 before = target(ids_[2]);
  animate();
  ASSERT_EQ(animation().tracks.size(), 1U);
  const auto& track = animation().tracks[0].position;
  ASSERT_EQ(track.size(), 2U);
  EXPECT_EQ(track[0].frame, 0);
  EXPECT_EQ(track[0].value, before);
  EXPECT_EQ(track[1].frame, 8);
  EXPECT_GT((track[1].value - before).norm(), 0.01);
}

TEST_F(EditorMotion, ADragAndItsKeyAreOneUndoStep) {
  const std::size_t steps = editor_->draft().history().steps().size();
  motion().go_to(8);
  frame();
  drag_handle(ids_[2], {0, -40});
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  editor_->draft().undo();
  EXPECT_TRUE(keys_of(animation()).empty());
}

TEST_F(EditorMotion, ShowsTheFrameAtThePlayHeadAndItsTargets) {
  animate();
  const auto frames = &motion().frames();
  for (const int f : {3, 11, 0, 8, 5}) {
    motion().go_to(f);
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

TEST_F(EditorMotion, AnEditGoesOnFromTheFrame) {
  animate();
  motion().go_to(4);
  frame();
  const Points shown = editor_->shown()->deformed;
  const Vec2 at = pixel_of(shown_at(ids_[2]));
  press(at);
  move(at + Vec2(6, 0));
  EXPECT_EQ(editor_->document().pose->deformed, shown);
  release(at + Vec2(6, 0));
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 8}));
}

TEST_F(EditorMotion, AHandleWithoutKeysMovesInAllFramesWhereNothingIsRecorded) {
  animate();
  key(Key::i, kShift);
  EXPECT_FALSE(motion().records());
  motion().go_to(4);
  frame();
  drag_handle(ids_[0], {-20, 0});
  EXPECT_EQ(key_frames(), (std::vector{0, 8}));
  drag_handle(ids_[2], {-20, 0});
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 8})) << "that has keys, and gets one more";
}

TEST_F(EditorMotion, MovingAKeySolvesOnlyWhatFollowsIt) {
  animate();
  motion().go_to(11);
  frame();
  drag_handle(ids_[2], {30, 0});
  solve_all();
  std::vector<std::shared_ptr<const SolvedFrame>> before;
  for (int f = 0; f < 12; ++f) before.push_back(motion().frames().frame(f));
  motion().select({{ids_[2], KeyedProperty::position, 11}});
  motion().move_selected([](int f) { return f - 1; }, false);
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
  motion().go_to(3);
  frame();
  const auto& handles = editor_->shown()->handles;
  const auto hand = std::find_if(handles.begin(), handles.end(),
                                 [&](const Handle& h) { return h.id == ids_[2]; });
  EXPECT_EQ(hand->name, "hand");
}

TEST_F(EditorMotion, PlaysAtItsFrameRateAndBeginsAnew) {
  animate();
  motion().set_fps(60);
  motion().go_to(0);
  key(Key::space);
  ASSERT_TRUE(motion().is_playing());
  EXPECT_TRUE(editor_->next_wake());
  for (int f = 1; f <= 14; ++f) {
    frame();
    EXPECT_EQ(motion().frame(), f % 12);
  }
  key(Key::space);
  EXPECT_FALSE(motion().is_playing());
  const int stays = motion().frame();
  frame();
  EXPECT_EQ(motion().frame(), stays);
}

TEST_F(EditorMotion, KeysOfTheKeyboardMoveThePlayHead) {
  animate();
  motion().go_to(0);
  key(Key::period);
  EXPECT_EQ(motion().frame(), 1);
  key(Key::comma);
  key(Key::comma);
  EXPECT_EQ(motion().frame(), 11) << "round the end";
  key(Key::comma, kShift);
  EXPECT_EQ(motion().frame(), 0);
  key(Key::period, kAlt);
  EXPECT_EQ(motion().frame(), 8);
  key(Key::comma, kAlt);
  EXPECT_EQ(motion().frame(), 0);
  key(Key::period, kShift);
  EXPECT_EQ(motion().frame(), 11);
}

TEST_F(EditorMotion, KeysAreSetCopiedPastedAndDeletedByTheKeyboard) {
  editor_->selection().select({ids_[1]});
  motion().go_to(3);
  key(Key::i);
  EXPECT_EQ(keys_of(animation()), (Keys{{ids_[1], KeyedProperty::position, 3}}));
  motion().select(keys_of(animation()));
  key(Key::c, kControl);
  motion().go_to(9);
  key(Key::v, kControl);
  EXPECT_EQ(key_frames(), (std::vector{3, 9}));
  EXPECT_EQ(motion().selected(), (Keys{{ids_[1], KeyedProperty::position, 9}}));
  key(Key::del);
  EXPECT_EQ(key_frames(), std::vector{3});
  EXPECT_EQ(editor_->document().handles.size(), 3U) << "keys went, not handles";
  editor_->draft().undo();
  EXPECT_EQ(key_frames(), (std::vector{3, 9}));
}

TEST_F(EditorMotion, EasingPathsAndSwingAreSteps) {
  animate();
  motion().select(keys_of(animation()));
  motion().set_easing(*find_easing("both"));
  EXPECT_EQ(animation().tracks[0].position[0].easing, *find_easing("both"));
  editor_->selection().select({ids_[2]});
  editor_->run_command("motion.smooth");
  EXPECT_TRUE(animation().tracks[0].is_smooth);
  editor_->selection().select({ids_[2]});
  editor_->selection().select({ids_[2], ids_[0]});
  editor_->run_command("motion.swing");
  ASSERT_EQ(animation().groups.size(), 1U);
  EXPECT_EQ(animation().groups[0].handles, std::vector{ids_[2]});
  EXPECT_EQ(animation().groups[0].center, target(ids_[0]));
  editor_->run_command("motion.swing");
  EXPECT_TRUE(animation().groups.empty());
  for (int i = 0; i < 4; ++i) editor_->draft().undo();
  EXPECT_FALSE(animation().tracks[0].is_smooth);
  EXPECT_EQ(animation().tracks[0].position[0].easing, Easing{});
}

TEST_F(EditorMotion, OutlinesAreOfTheKeysBeforeAndAfter) {
  animate();
  motion().go_to(4);
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

TEST_F(EditorMotion, FieldsAreOfTheFrameAndSetAKeyThere) {
  animate();
  motion().go_to(4);
  frame();
  editor_->selection().select({ids_[2]});
  const auto& track = animation().tracks[0].position;
  const Vec2 middle = (track[0].value + track[1].value) / 2;
  EXPECT_NEAR(*selected_handles(*editor_).y, middle.y(), 1e-12);
  set_coordinate(*editor_, 0, middle.x() + 0.25);
  frame();
  ASSERT_EQ(key_frames(), (std::vector{0, 4, 8}));
  EXPECT_NEAR((animation().tracks[0].position[1].value - middle - Vec2(0.25, 0)).norm(), 0, 1e-12);
}

TEST_F(EditorMotion, NudgesAtAFrameAreOneStepAndOneKey) {
  animate();
  motion().go_to(4);
  frame();
  editor_->selection().select({ids_[2]});
  const Vec2 before = editor_->shown()->handles.back().target;
  const std::size_t steps = editor_->draft().history().steps().size();
  for (int i = 0; i < 3; ++i) {
    key(Key::right);
    solve_all();
  }
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  ASSERT_EQ(key_frames(), (std::vector{0, 4, 8}));
  const Vec2 way = animation().tracks[0].position[1].value - before;
  EXPECT_GT(way.x(), 0);
  EXPECT_NEAR(way.y(), 0, 1e-12);
  editor_->draft().undo();
  EXPECT_EQ(key_frames(), (std::vector{0, 8}));
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
