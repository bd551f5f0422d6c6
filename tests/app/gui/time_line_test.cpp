// SPDX-License-Identifier: GPL-3.0-or-later
// The time line under the mouse: the whole editor off screen.
#include <gtest/gtest.h>

#include "app/gui/time_line_place.h"
#include "tests/app/gui/animated_bar.h"

namespace foldless::test {
namespace {

constexpr auto kPosition = KeyedProperty::position;

/// A bar with two handles, of which the second has keys at frames 0, 10 and 20 of 25.
class TimeLine : public testing::Test {
 protected:
  TimeLine() { open_animated_bar(headless_); }

  Motion& motion() { return headless_.editor().motion(); }
  TimeLinePlace place() {
    return time_line_place(headless_.ui().layout().timeline, 1, motion().animation().cycle, {});
  }
  /// A key of the only row; row −1 is that of all.
  Vec2 at(int frame, int row = 0) {
    return {place().x_of(frame), row < 0 ? place().y_of_all() : place().y_of(row)};
  }
  Vec2 ruler(int frame) { return {place().x_of(frame), place().area.y + 6}; }
  void drag(const Vec2& from, const Vec2& to) {
    headless_.press(from);
    headless_.move(from + (to - from) / 2);
    headless_.move(to);
    headless_.release(to);
    headless_.settle();
  }
  void drag_with(Modifiers modifiers, const Vec2& from, const Vec2& to) {
    headless_.hold(modifiers);
    drag(from, to);
    headless_.hold({});
  }
  std::vector<int> key_frames() {
    std::vector<int> frames;
    for (const KeyPlace& key : keys_of(motion().animation())) frames.push_back(key.frame);
    return frames;
  }
  static Keys keys(const std::vector<int>& frames) {
    Keys result;
    for (const int frame : frames) result.insert({1, kPosition, frame});
    return result;
  }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_F(TimeLine, TheRulerMovesThePlayHead) {
  headless_.click(ruler(7));
  headless_.settle();
  EXPECT_EQ(motion().play_head().frame(), 7);
  EXPECT_EQ(headless_.editor().shown()->deformed, motion().frames().frame(7)->snapshot->deformed);
  drag(ruler(7), ruler(18));
  EXPECT_EQ(motion().play_head().frame(), 18);
  drag(ruler(18), ruler(24) + Vec2(500, 0));
  EXPECT_EQ(motion().play_head().frame(), 24);
}

TEST_F(TimeLine, AClickSelectsAKeyAndShiftOneMore) {
  headless_.click(at(10));
  headless_.settle();
  EXPECT_EQ(motion().keys().selected(), keys({10}));
  headless_.hold({.shift = true});
  headless_.click(at(20));
  headless_.settle();
  EXPECT_EQ(motion().keys().selected(), keys({10, 20}));
  headless_.click(at(10));
  headless_.settle();
  headless_.hold({});
  EXPECT_EQ(motion().keys().selected(), keys({20}));
  headless_.click(at(5));
  headless_.settle();
  EXPECT_TRUE(motion().keys().selected().empty());
}

TEST_F(TimeLine, AKeyIsMovedByItsDiamondInOneStep) {
  const std::size_t steps = headless_.editor().draft().history().steps().size();
  drag(at(10), at(13));
  EXPECT_EQ(key_frames(), (std::vector{0, 13, 20}));
  EXPECT_EQ(motion().keys().selected(), keys({13}));
  EXPECT_EQ(headless_.editor().draft().history().steps().size(), steps + 1);
  headless_.key(Key::z, kControl);
  headless_.settle();
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 20}));
}

TEST_F(TimeLine, SeveralKeysAreSelectedByABandAndMovedTogether) {
  drag(at(8) + Vec2(0, -6), at(22) + Vec2(0, 6));
  EXPECT_EQ(motion().keys().selected(), keys({10, 20}));
  drag(at(10), at(12));
  EXPECT_EQ(key_frames(), (std::vector{0, 12, 22}));
}

TEST_F(TimeLine, KeysThatArePulledOverTheEndKeepTheirDistance) {
  drag(at(8) + Vec2(0, -6), at(22) + Vec2(0, 6));
  drag(at(10), at(24));
  EXPECT_EQ(key_frames(), (std::vector{0, 14, 24}));
  drag(at(24), at(0));
  EXPECT_EQ(key_frames(), (std::vector{0, 10})) << "the key that was at frame 0 is covered";
}

TEST_F(TimeLine, TheRowOfAllMovesWhatIsInAFrame) {
  drag(at(20, -1), at(24, -1));
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 24}));
}

TEST_F(TimeLine, ControlCopiesAKey) {
  drag_with({.control = true}, at(10), at(15));
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 15, 20}));
}

TEST_F(TimeLine, AltStretchesWhatIsSelected) {
  drag(at(0) + Vec2(-9, -6), at(22) + Vec2(0, 6));
  EXPECT_EQ(motion().keys().selected().size(), 3U);
  drag_with({.alt = true}, at(20), at(24));
  EXPECT_EQ(key_frames(), (std::vector{0, 12, 24}));
}

TEST_F(TimeLine, EscapePutsTheKeysBack) {
  headless_.press(at(10));
  headless_.move(at(14));
  headless_.key(Key::escape);
  headless_.release(at(14));
  headless_.settle();
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 20}));
}

TEST_F(TimeLine, DeleteTakesSelectedKeysAndNoHandle) {
  headless_.editor().selection().select({1});
  headless_.click(at(10));
  headless_.key(Key::del);
  headless_.settle();
  EXPECT_EQ(key_frames(), (std::vector{0, 20}));
  EXPECT_EQ(headless_.editor().document().handles.size(), 2U);
}

TEST_F(TimeLine, ADoubleClickOnARowSetsAKeyWithTheValueThatIsThere) {
  for (int click = 0; click < 2; ++click) headless_.click(at(5));
  headless_.settle();
  EXPECT_EQ(key_frames(), (std::vector{0, 5, 10, 20}));
  const auto& track = motion().animation().tracks[0].position;
  EXPECT_NEAR((track[1].value - (track[0].value + track[2].value) / 2).norm(), 0, 1e-12);
}

TEST_F(TimeLine, TheNameOfARowSelectsItsHandle) {
  headless_.click({place().area.x + 20, place().y_of(0)});
  headless_.settle();
  EXPECT_EQ(headless_.editor().selection().ids(), std::set{1});
}

TEST_F(TimeLine, TheRightButtonOffersEasings) {
  headless_.press(at(10), Button::right);
  headless_.release(at(10), Button::right);
  headless_.settle();
  EXPECT_EQ(motion().keys().selected(), keys({10}));
  const auto hold = headless_.find_words("Hold");
  ASSERT_TRUE(hold);
  headless_.click(*hold);
  headless_.settle();
  EXPECT_EQ(motion().animation().tracks[0].position[1].easing, *find_easing("hold"));
}

TEST_F(TimeLine, MarksFramesThatAreNotReached) {
  const Image before = headless_.picture();
  Document document = headless_.editor().document();
  document.parameters.method = "paper";
  document.parameters.alpha = 1e-6;  // handles pull hardly
  headless_.editor().draft().edit("Weak handles", document, Change::appearance);
  headless_.settle();
  headless_.wait_until([&] { return motion().frames().status().is_done; });
  headless_.settle();
  ASSERT_FALSE(motion().frames().frame(10)->is_satisfied);
  EXPECT_GT(differing_pixels(before, headless_.picture()), 20);
  headless_.click(ruler(10));
  headless_.settle();
  const auto status = [this] { return headless_.editor().status(); };
  EXPECT_EQ(status().kind, StatusKind::blocked);
  // The moments between the frames are proved meanwhile, and the words change once they are.
  const auto says_so = [&] { return headless_.find_words(status().words).has_value(); };
  EXPECT_TRUE(headless_.wait_until(says_so)) << status().words;
}

TEST_F(TimeLine, AHandleDraggedAtThePlayHeadGetsAKeyThere) {
  headless_.click(ruler(15));
  headless_.settle();
  const Vec2 from = headless_.window_point(headless_.editor().shown()->deformed.col(12));
  drag(from, from + Vec2(30, -20));
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 15, 20}));
}

TEST_F(TimeLine, ManyRowsAreScrolledByTheWheelAndNothingIsOutOfTheWindow) {
  EXPECT_LE(place().area.y + place().area.height, 800);
  Draft& draft = headless_.editor().draft();
  draft.begin_edit();
  Document document = draft.document();
  for (int vertex = 1; vertex < 10; ++vertex)
    document = place_handle(document, {.vertex = vertex}).document;
  draft.apply(document, Change::mesh);
  draft.commit("Handles");
  headless_.settle();
  ASSERT_EQ(headless_.editor().document().handles.size(), 11U);
  headless_.key(Key::i);
  headless_.settle();
  const int rows = static_cast<int>(time_line_rows(motion().animation()).size());
  ASSERT_GT(rows, place().rows_in_sight());
  headless_.move(at(5, 2));
  for (int i = 0; i < rows; ++i) headless_.ui().receive(InputEvent(WheelTurned{-1, at(5, 2)}));
  headless_.settle();
  headless_.click({place().area.x + 20, place().y_of(place().rows_in_sight() - 1)});
  headless_.settle();
  EXPECT_EQ(headless_.editor().selection().ids(),
            std::set{time_line_rows(motion().animation()).back().handle});
}

}  // namespace
}  // namespace foldless::test
