// SPDX-License-Identifier: GPL-3.0-or-later
// Iterations played as a film.
#include "app/editor/playback.h"

#include "tests/app/editor/editor_fixture.h"

namespace foldless::test {
namespace {

class Film : public EditorTest {
 protected:
  Film() {
    open_grid(7);
    place(0);
    place(48);
    drag(pixel_of_vertex(48), pixel_of(Vec2(1.5, 2)));
    settle();
  }

  Playback& playback() { return editor_->playback(); }
  std::size_t count() { return playback().iterations().size(); }
  /// Lets time go by in frames.
  void wait(double seconds) {
    for (const double end = now_ + seconds; now_ < end;) frame();
  }
  std::size_t shown() { return playback().scrubbed().value_or(count() - 1); }
};

TEST_F(Film, PlaysFromTheFirstToTheLastAndEnds) {
  ASSERT_GT(count(), 4U);
  key(Key::p);
  EXPECT_TRUE(playback().is_playing());
  EXPECT_EQ(shown(), 0U);
  std::size_t last = 0;
  for (int i = 0; i < 10000 && playback().is_playing(); ++i) {
    frame();
    EXPECT_LE(shown(), last + 1) << "none is left out";
    EXPECT_GE(shown(), last);
    last = shown();
  }
  EXPECT_FALSE(playback().is_playing());
  EXPECT_EQ(last, count() - 1);
  EXPECT_FALSE(playback().scrubbed());
  EXPECT_FALSE(editor_->next_wake()) << "a film that is over costs nothing";
}

TEST_F(Film, GoesOnFromTheIterationOnScreenAtThePace) {
  playback().set_pace(10);
  playback().scrub(1);
  key(Key::p);
  wait(0.25);
  EXPECT_EQ(shown(), 3U);
  key(Key::p);
  EXPECT_FALSE(playback().is_playing());
  wait(1);
  EXPECT_EQ(shown(), 3U);
}

TEST_F(Film, InALoopItBeginsAgain) {
  playback().set_pace(60);
  key(Key::p, kShift);
  key(Key::p);
  wait(static_cast<double>(count() + 2) / 60);
  EXPECT_TRUE(playback().is_playing());
  EXPECT_LT(shown(), 4U);
}

TEST_F(Film, AHandOnTheScrubberAnEditOrEscEndIt) {
  const auto play = [&] {
    playback().last();
    key(Key::p);
    frame();
    ASSERT_TRUE(playback().is_playing());
  };
  play();
  playback().scrub(2);
  EXPECT_FALSE(playback().is_playing());
  play();
  key(Key::escape);
  EXPECT_FALSE(playback().is_playing());
  EXPECT_TRUE(playback().scrubbed()) << "the iteration stays";
  play();
  press(pixel_of_vertex(48));
  move(pixel_of_vertex(48) + Vec2(30, 0));
  frame();
  EXPECT_FALSE(playback().is_playing());
}

TEST_F(Film, IsNotThereWithoutIterations) {
  open_grid(4);
  key(Key::p);
  EXPECT_FALSE(playback().is_playing());
}

}  // namespace
}  // namespace foldless::test
