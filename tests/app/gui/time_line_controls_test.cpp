// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the keys of the time line, under the mouse and the keyboard: the whole editor
// off screen.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/gui/time_line_place.h"
#include "tests/app/gui/animated_bar.h"

namespace foldless::test {
namespace {

class TimeLineControls : public testing::Test {
 protected:
  TimeLineControls() { open_animated_bar(headless_); }

  Motion& motion() { return headless_.editor().motion(); }
  const Animation& animation() { return motion().animation(); }
  std::size_t steps() { return headless_.editor().draft().history().steps().size(); }
  void click_on(const char* words, const Vec2& beside = {0, 0}) {
    const auto place = headless_.find_words(words);
    ASSERT_TRUE(place) << words;
    headless_.click(*place + beside);
    headless_.settle();
  }
  void type_over(const char* number) {
    headless_.key(Key::a, kControl);
    headless_.type(number);
    headless_.key(Key::enter);
    headless_.settle();
  }
  void solve_all() {
    headless_.settle();
    ASSERT_TRUE(headless_.wait_until([this] { return motion().frames().status().is_done; }));
    headless_.settle();
  }
  /// Of Motion, in the bar of menus.
  void choose(const char* entry) {
    click_on("Motion");
    click_on(entry);
  }
  std::vector<int> key_frames() {
    std::vector<int> frames;
    for (const KeyPlace& key : keys_of(animation())) frames.push_back(key.frame);
    return frames;
  }
  TimeLinePlace place() {
    return time_line_place(headless_.ui().layout().timeline, 1, animation().cycle, {});
  }
  Vec2 key_at(int frame) { return {place().x_of(frame), place().y_of(0)}; }
  void select_key(int frame) {
    headless_.click(key_at(frame));
    headless_.settle();
  }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_F(TimeLineControls, LoopIsTickedInOneStepAndClosesTheShape) {
  ASSERT_FALSE(animation().cycle.loops);
  const std::size_t before = steps();
  click_on("Loop");
  EXPECT_TRUE(animation().cycle.loops);
  EXPECT_EQ(steps(), before + 1);
  solve_all();
  const FramesStatus status = motion().frames().status();
  ASSERT_TRUE(status.gap);
  EXPECT_LT(*status.gap, 0.05);
  click_on("Loop");
  EXPECT_FALSE(animation().cycle.loops);
}

TEST_F(TimeLineControls, FramesAndTheirRateAreTypedInOneStepEach) {
  const std::size_t before = steps();
  click_on("frames", {-50, 0});
  type_over("31");
  EXPECT_EQ(animation().cycle.frames, 31);
  click_on("fps", {-40, 0});
  type_over("12.5");
  EXPECT_EQ(animation().fps, 12.5);
  EXPECT_EQ(steps(), before + 2);
}

TEST_F(TimeLineControls, SpacePlaysAndTheFramesOnScreenAreThoseOfTheTimeLine) {
  motion().play_head().go_to(0);
  headless_.key(Key::space);
  ASSERT_TRUE(motion().play_head().is_playing());
  std::set<int> seen;
  ASSERT_TRUE(headless_.wait_until([&] {
    EXPECT_EQ(headless_.editor().shown()->deformed,
              motion().frames().frame(motion().play_head().frame())->snapshot->deformed);
    seen.insert(motion().play_head().frame());
    return seen.size() == 25;
  })) << "it begins anew at its end";
  headless_.key(Key::space);
  EXPECT_FALSE(motion().play_head().is_playing());
}

TEST_F(TimeLineControls, ScrubbedAtRandomFramesLookAsTheyDoWhenTheyArePlayed) {
  std::map<int, Image> played;
  for (int f = 0; f < 25; f += 3) {
    motion().play_head().go_to(f);
    headless_.settle();
    played[f] = headless_.canvas_picture();
  }
  for (const int f : {18, 3, 24, 0, 12, 21}) {
    headless_.click({place().x_of(f), place().area.y + 6});
    headless_.calm_down();
    ASSERT_EQ(motion().play_head().frame(), f);
    EXPECT_EQ(headless_.editor().shown()->deformed, motion().frames().frame(f)->snapshot->deformed);
    EXPECT_EQ(differing_pixels(headless_.canvas_picture(), played[f]), 0) << f;
  }
}

TEST_F(TimeLineControls, OutlinesOfNeighbouringKeysAreDrawnWithU) {
  headless_.click({place().x_of(5), place().area.y + 6});
  headless_.calm_down();
  const Image without = headless_.canvas_picture();
  headless_.key(Key::u);
  headless_.calm_down();
  EXPECT_GT(differing_pixels(headless_.canvas_picture(), without), 200);
  headless_.key(Key::u);
  headless_.calm_down();
  EXPECT_EQ(differing_pixels(headless_.canvas_picture(), without), 0);
}

TEST_F(TimeLineControls, KeysAreCopiedPastedAndSetByTheKeyboard) {
  select_key(10);
  headless_.key(Key::c, kControl);
  headless_.click({place().x_of(16), place().area.y + 6});
  headless_.settle();
  headless_.key(Key::v, kControl);
  EXPECT_EQ(key_frames(), (std::vector{0, 10, 16, 20}));
  EXPECT_EQ(animation().tracks[0].position[2].value, animation().tracks[0].position[1].value);
  headless_.editor().selection().select({1});
  headless_.click({place().x_of(4), place().area.y + 6});
  headless_.settle();
  headless_.key(Key::i);
  EXPECT_EQ(key_frames(), (std::vector{0, 4, 10, 16, 20}));
}

TEST_F(TimeLineControls, AnEasingIsChosenInItsListForAllSelectedKeys) {
  select_key(0);
  headless_.hold({.shift = true});
  select_key(10);
  headless_.hold({});
  click_on("Linear");
  click_on("Both");
  for (const int i : {0, 1})
    EXPECT_EQ(animation().tracks[0].position[static_cast<std::size_t>(i)].easing,
              *find_easing("both"));
  EXPECT_EQ(animation().tracks[0].position[2].easing, Easing{});
  solve_all();
  const auto targets = handles_at(animation(), headless_.editor().document().handles, 2);
  EXPECT_LT(targets[1].target.y() - animation().tracks[0].position[0].value.y(), 0.15)
      << "it begins slowly";
}

TEST_F(TimeLineControls, SmoothPathsAreAnArcInPlaceOfACorner) {
  headless_.editor().selection().select({1});
  const auto at = [&](int frame) {
    return handles_at(animation(), headless_.editor().document().handles, frame)[1].target;
  };
  const Vec2 straight = at(15);
  choose("Smooth paths");
  EXPECT_TRUE(animation().tracks[0].is_smooth);
  EXPECT_GT(at(15).y(), straight.y() + 0.01) << "it goes on upwards before it turns";
  solve_all();
  EXPECT_EQ(motion().frames().frame(15)->snapshot->handles[1].target, at(15));
  choose("Smooth paths");
  EXPECT_EQ(at(15), straight);
}

TEST_F(TimeLineControls, ASwingKeepsItsDistanceFromTheHandleSelectedLast) {
  headless_.editor().selection().select({1});
  headless_.editor().selection().select({1, 0});
  const auto handles = headless_.editor().document().handles;
  choose("Swing about the handle selected last");
  ASSERT_EQ(animation().groups.size(), 1U);
  const Vec2 centre = animation().groups[0].center;
  EXPECT_EQ(centre, handles[0].target);
  const auto distance = [&](int frame) {
    return (handles_at(animation(), handles, frame)[1].target - centre).norm();
  };
  const double less = std::min(distance(0), distance(10));
  const double more = std::max(distance(0), distance(10));
  for (const int frame : {3, 5, 7}) {
    EXPECT_GE(distance(frame), less - 1e-9) << "no straight line, which comes nearer";
    EXPECT_LE(distance(frame), more + 1e-9);
  }
  choose("Swing about the handle selected last");
  EXPECT_TRUE(animation().groups.empty());
}

}  // namespace
}  // namespace foldless::test
