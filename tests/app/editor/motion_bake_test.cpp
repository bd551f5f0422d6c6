// SPDX-License-Identifier: GPL-3.0-or-later
// What is between the frames of the time line: the bake that proves it, and the play head there.
#include "app/editor/motion_bake.h"

#include "app/editor/swing_centre.h"
#include "tests/app/editor/motion_fixture.h"

namespace foldless::test {
namespace {

using State = MotionProofStatus::State;

class BetweenFrames : public EditorMotion {
 protected:
  void wait_for_proof() {
    wait_for([this] { return motion().proof().state == State::proved; });
  }
  void wait_at(double moment) {
    motion().play_head().go_between(moment);
    wait_for([this] { return motion().solved() != nullptr; });
    frame();
  }
};

TEST_F(BetweenFrames, EveryMomentIsProvedOnceAllFramesAreSolved) {
  EXPECT_EQ(motion().proof().state, State::none);
  animate();
  wait_for_proof();
  const MotionProofStatus proof = motion().proof();
  EXPECT_EQ(proof.frames, 12U);
  EXPECT_GE(proof.vertices, 81);
  EXPECT_LE(proof.deviation, 0.5);
  EXPECT_TRUE(failures_of(motion().bake().result()->baked).empty());
  EXPECT_NE(editor_->status().words.find("every moment of the animation proved injective"),
            std::string::npos)
      << editor_->status().words;
}

TEST_F(BetweenFrames, AnEditDropsTheProofAndItComesBack) {
  animate();
  wait_for_proof();
  const auto before = motion().bake().result();
  motion().keys().select({{ids_[2], KeyedProperty::position, 8}});
  motion().keys().move_selected([](int f) { return f - 1; }, false);
  frame();
  EXPECT_NE(motion().proof().state, State::proved);
  wait_for_proof();
  EXPECT_NE(motion().bake().result(), before);
}

TEST_F(BetweenFrames, NamesBakeNothingAnew) {
  animate();
  wait_for_proof();
  const auto before = motion().bake().result();
  motion().keys().select(keys_of(animation()));
  motion().play_head().go_to(3);
  for (int i = 0; i < 3; ++i) frame();
  EXPECT_EQ(motion().bake().result(), before);
}

TEST_F(BetweenFrames, APressThatChangesNothingKeepsTheProof) {
  animate();
  wait_for_proof();
  const auto before = motion().bake().result();
  const Vec2 at = pixel_of(shown_at(ids_[2]));
  press(at);
  frame();
  release(at);
  frame();
  EXPECT_EQ(motion().bake().result(), before);
  EXPECT_EQ(motion().proof().state, State::proved);
}

TEST_F(BetweenFrames, ThePlayHeadShowsASolvedAndProvedMoment) {
  animate();
  for (const double moment : {3.5, 7.25, 0.125}) {
    wait_at(moment);
    EXPECT_EQ(motion().play_head().moment(), moment);
    EXPECT_TRUE(is_valid());
    EXPECT_TRUE(editor_->draft().proof().holds());
    const Frames frames(animation_to_solve(editor_->document()).at_rest, animation());
    const auto expected =
        frames.solve(moment, motion().frames().frame(static_cast<int>(moment))->snapshot.get(), {});
    EXPECT_EQ(editor_->shown()->deformed, expected->snapshot->deformed) << moment;
    const auto targets = handles_at(animation(), editor_->document().handles, moment);
    EXPECT_EQ(editor_->shown()->handles[2].target, targets[2].target);
  }
}

TEST_F(BetweenFrames, StepsGoToTheFramesBeside) {
  animate();
  motion().play_head().go_between(3.75);
  EXPECT_EQ(motion().play_head().frame(), 4);
  key(Key::period);
  EXPECT_EQ(motion().play_head().moment(), 4);
  motion().play_head().go_between(3.25);
  key(Key::comma);
  EXPECT_EQ(motion().play_head().moment(), 3);
  motion().play_head().go_between(2.5);
  key(Key::comma, kShift);
  EXPECT_EQ(motion().play_head().moment(), 0);
}

TEST_F(BetweenFrames, StaysWithinTheCycle) {
  animate();
  motion().play_head().go_between(99);
  EXPECT_EQ(motion().play_head().moment(), 11);
  motion().play_head().go_between(-1);
  EXPECT_EQ(motion().play_head().moment(), 0);
  motion().play_head().go_between(10.5);
  motion().keys().set_cycle({9, false});
  frame();
  EXPECT_EQ(motion().play_head().moment(), 8);
  motion().keys().set_cycle({9, true});
  motion().play_head().go_between(8.5);
  EXPECT_EQ(motion().play_head().moment(), 8.5) << "a loop goes on to its beginning";
}

TEST_F(BetweenFrames, AnEditSetsAKeyAtTheNearestFrame) {
  animate();
  wait_at(3.75);
  const Vec2 at = pixel_of(shown_at(ids_[2]));
  drag(at, at + Vec2(12, 0));
  frame();
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 8}));
  EXPECT_EQ(motion().play_head().moment(), 4);
}

TEST_F(BetweenFrames, PlayingGoesByFrames) {
  animate();
  motion().play_head().go_between(3.25);
  key(Key::space);
  frame();
  EXPECT_EQ(motion().play_head().moment(), motion().play_head().frame());
}

TEST_F(BetweenFrames, TheCentreOfASwingIsPulledByItsGripInOneStep) {
  animate();
  editor_->selection().select({ids_[2]});
  editor_->selection().select({ids_[2], ids_[0]});
  editor_->run_command("motion.swing");
  solve_all();
  const Vec2 centre = animation().groups[0].center;
  const std::size_t steps = editor_->draft().history().steps().size();
  const Vec2 grip = swing_grip(editor_->canvas(), centre);
  drag(grip, grip + Vec2(40, -20));
  frame();
  EXPECT_NEAR((pixel_of(animation().groups[0].center) - pixel_of(centre) - Vec2(40, -20)).norm(), 0,
              1e-6);
  EXPECT_EQ(editor_->draft().history().steps().size(), steps + 1);
  EXPECT_EQ(key_frames(), (std::vector{0, 8})) << "no handle was moved";
  press(grip + Vec2(40, -20));
  move(grip + Vec2(80, 60));
  key(Key::escape);
  EXPECT_NEAR((pixel_of(animation().groups[0].center) - pixel_of(centre) - Vec2(40, -20)).norm(), 0,
              1e-6);
  editor_->draft().undo();
  EXPECT_EQ(animation().groups[0].center, centre);
}

}  // namespace
}  // namespace foldless::test
