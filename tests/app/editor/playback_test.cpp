// SPDX-License-Identifier: GPL-3.0-or-later
// Iterations played as a film.
#include "app/editor/playback.h"

#include <functional>

#include "app/editor/parameter_rows.h"
#include "core/energy/densities.h"
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

TEST_F(Film, AnEditThatIsNotAboutThePoseKeepsTheIterationOnScreen) {
  const TemporaryFolder folder;
  const auto picture = folder.write("a.png", "no image, but a file");
  const std::vector<std::function<void()>> edits{
      [&] { editor_->edits().set_energy(*find_density("symmetric-dirichlet")); },
      [&] { editor_->edits().set_parameter(*find_parameter_row("alpha"), 1e6); },
      [&] { editor_->files().set_texture(picture); },
      [&] {
        editor_->brush().press(editor_->canvas(), pixel_of_vertex(24), false);
        editor_->brush().release();
      }};
  for (std::size_t k = 0; k < edits.size(); ++k) {
    SCOPED_TRACE(k);
    const Vec2 from = pixel_of_handle(1);
    drag(from, from + Vec2(k % 2 ? 70 : -90, k % 2 ? -80 : 110));
    settle();
    editor_->playback().scrub(0);
    ASSERT_TRUE(editor_->playback().scrubbed());
    const Points shown = editor_->shown()->deformed;
    const std::size_t steps = editor_->draft().history().steps().size();
    edits[k]();
    ASSERT_EQ(editor_->draft().history().steps().size(), steps + 1);
    EXPECT_EQ(editor_->document().pose->deformed, shown);
  }
}

}  // namespace
}  // namespace foldless::test
