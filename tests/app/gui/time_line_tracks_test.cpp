// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of positions, angles, depths and weights by the gestures that set them: the whole editor off
// screen.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/handle_edits.h"
#include "app/editor/turning.h"
#include "app/gui/time_line_place.h"
#include "tests/app/gui/animated_bar.h"

namespace foldless::test {
namespace {

class TimeLineTracks : public testing::Test {
 protected:
  static constexpr auto kPosition = KeyedProperty::position;
  static constexpr auto kAngle = KeyedProperty::angle;
  static constexpr auto kDepth = KeyedProperty::depth;
  static constexpr auto kWeight = KeyedProperty::weight;

  TimeLineTracks() { open_bar_with_all_tracks(headless_); }

  Editor& editor() { return headless_.editor(); }
  Motion& motion() { return editor().motion(); }
  const HandleTracks& tracks() { return motion().animation().tracks[0]; }
  std::size_t steps() { return editor().draft().history().current(); }
  TimeLinePlace place() {
    return time_line_place(headless_.ui().layout().timeline, 1, motion().animation().cycle, {});
  }
  Vec2 at(int frame, KeyedProperty property) {
    return {place().x_of(frame), place().y_of(static_cast<int>(property))};
  }
  Vec2 at_all(int frame) { return {place().x_of(frame), place().y_of_all()}; }
  void go_to(int frame) {
    headless_.click({place().x_of(frame), place().area.y + 6});
    headless_.settle();
  }
  void select_handle() {
    editor().selection().select({1});
    headless_.settle();
  }
  void double_click(const Vec2& where) {
    for (int click = 0; click < 2; ++click) headless_.click(where);
    headless_.settle();
  }
  std::vector<int> frames_of(KeyedProperty property) {
    std::vector<int> frames;
    for (const KeyPlace& key : keys_of(motion().animation()))
      if (key.handle == 1 && key.property == property) frames.push_back(key.frame);
    return frames;
  }
  /// One step came about, which has one key more in one row; undo takes it back.
  void expect_one_key(KeyedProperty property, int frame, std::size_t steps_before,
                      const Animation& before) {
    EXPECT_EQ(steps(), steps_before + 1);
    Keys expected = keys_of(before);
    expected.insert({1, property, frame});
    EXPECT_EQ(keys_of(motion().animation()), expected);
    headless_.key(Key::z, kControl);
    headless_.settle();
    EXPECT_EQ(motion().animation(), before);
  }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_F(TimeLineTracks, EveryPropertyHasARowAndItsDiamondsAreCaughtThere) {
  ASSERT_GE(place().rows_in_sight(), 4) << "none is scrolled";
  for (const auto& [property, frame] :
       {std::pair{kPosition, 20}, {kAngle, 16}, {kDepth, 10}, {kWeight, 10}}) {
    headless_.click(at(frame, property));
    headless_.settle();
    EXPECT_EQ(motion().keys().selected(), (Keys{{1, property, frame}}));
  }
}

TEST_F(TimeLineTracks, ADoubleClickOnARowSetsAKeyOfThatRowAlone) {
  const Animation before = motion().animation();
  for (const KeyedProperty property : {kPosition, kAngle, kDepth, kWeight}) {
    const std::size_t count = steps();
    double_click(at(5, property));
    EXPECT_EQ(motion().play_head().frame(), 5);
    expect_one_key(property, 5, count, before);
  }
  double_click(at(5, kDepth));
  EXPECT_EQ(tracks().depth[1].value, 1) << "that is there";
  double_click(at(5, kWeight));
  EXPECT_EQ(tracks().weight[1].value, 15);
}

TEST_F(TimeLineTracks, ADoubleClickOnTheRowOfAllSetsKeysOfAllThatHasSome) {
  double_click(at_all(5));
  for (const KeyedProperty property : {kPosition, kAngle, kDepth, kWeight})
    EXPECT_EQ(std::ranges::count(frames_of(property), 5), 1) << static_cast<int>(property);
  EXPECT_FALSE(has_keys(motion().animation(), 0, kDepth)) << "what has none gets none";
}

TEST_F(TimeLineTracks, ISetsKeysOfDepthAndWeightWhereTheseHaveSome) {
  const Animation before = motion().animation();
  select_handle();
  go_to(7);
  const std::size_t count = steps();
  headless_.key(Key::i);
  headless_.settle();
  EXPECT_EQ(steps(), count + 1);
  for (const KeyedProperty property : {kPosition, kAngle, kDepth, kWeight})
    EXPECT_EQ(std::ranges::count(frames_of(property), 7), 1) << static_cast<int>(property);
  headless_.key(Key::z, kControl);
  headless_.settle();
  EXPECT_EQ(motion().animation(), before);
}

TEST_F(TimeLineTracks, TheRingSetsAKeyOfTheAngle) {
  const Animation before = motion().animation();
  go_to(4);
  select_handle();
  ASSERT_TRUE(handle_ring(editor()));
  const std::size_t count = steps();
  const HandleRing ring = *handle_ring(editor());
  const Rectangle& view = headless_.ui().layout().canvas;
  const auto on_ring = [&](double angle) -> Vec2 {
    return Vec2(view.x, view.y) + ring.centre +
           ring.radius * Vec2(std::cos(angle), -std::sin(angle));
  };
  headless_.press(on_ring(2));
  for (double angle = 2; angle < 2.6; angle += 0.1) headless_.move(on_ring(angle));
  headless_.release(on_ring(2.6));
  headless_.settle();
  ASSERT_EQ(frames_of(kAngle), (std::vector{0, 4, 16}));
  EXPECT_GT(tracks().angle[1].value, 7.5 + 10);
  expect_one_key(kAngle, 4, count, before);
}

TEST_F(TimeLineTracks, RAndANumberSetAKeyOfTheAngle) {
  const Animation before = motion().animation();
  go_to(8);
  select_handle();
  headless_.move(headless_.window_point(editor().shown()->deformed.col(12)) + Vec2(60, 0));
  const std::size_t count = steps();
  headless_.key(Key::r);
  for (const Key key : {Key::digit_2, Key::digit_0, Key::enter}) headless_.key(key);
  headless_.settle();
  ASSERT_EQ(frames_of(kAngle), (std::vector{0, 8, 16}));
  EXPECT_NEAR(tracks().angle[1].value, 15 + 20, 1e-9);
  expect_one_key(kAngle, 8, count, before);
}

TEST_F(TimeLineTracks, BracketsSetAKeyOfTheDepth) {
  const Animation before = motion().animation();
  go_to(5);
  select_handle();
  const std::size_t count = steps();
  headless_.key(Key::right_bracket);
  headless_.settle();
  ASSERT_EQ(frames_of(kDepth), (std::vector{0, 5, 10}));
  EXPECT_EQ(tracks().depth[1].value, 2);
  expect_one_key(kDepth, 5, count, before);
}

TEST_F(TimeLineTracks, TheFieldOfTheWeightSetsAKey) {
  const Animation before = motion().animation();
  go_to(5);
  select_handle();
  const auto label = headless_.find_words("Weight");
  ASSERT_TRUE(label);
  const std::size_t count = steps();
  headless_.click(*label + Vec2(70, 0));
  headless_.key(Key::a, kControl);
  headless_.type("40");
  headless_.key(Key::enter);
  headless_.settle();
  ASSERT_EQ(frames_of(kWeight), (std::vector{0, 5, 10}));
  EXPECT_EQ(tracks().weight[1].value, 40);
  expect_one_key(kWeight, 5, count, before);
}

}  // namespace
}  // namespace foldless::test
