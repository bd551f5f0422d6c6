// SPDX-License-Identifier: GPL-3.0-or-later
// Menus, buttons, keys of the keyboard, Esc and undo on the time line: the whole editor off screen.
#include <gtest/gtest.h>

#include "app/editor/swing_centre.h"
#include "app/gui/time_line_place.h"
#include "tests/app/gui/animated_bar.h"

namespace foldless::test {
namespace {

/// A bar of whose second handle everything has keys, at frames 0, 10, 16 and 20.
class TimeLineGestures : public testing::Test {
 protected:
  TimeLineGestures() { open_bar_with_all_tracks(headless_); }

  Editor& editor() { return headless_.editor(); }
  Motion& motion() { return editor().motion(); }
  const Animation& animation() { return motion().animation(); }
  std::size_t steps() { return editor().draft().history().current(); }
  TimeLinePlace place() {
    return time_line_place(headless_.ui().layout().timeline, 1, animation().cycle, {});
  }
  Vec2 at(int frame, KeyedProperty property) {
    return {place().x_of(frame), place().y_of(static_cast<int>(property))};
  }
  Vec2 depth_at(int frame) { return at(frame, KeyedProperty::depth); }
  static Keys depths(const std::vector<int>& frames) {
    Keys keys;
    for (const int frame : frames) keys.insert({1, KeyedProperty::depth, frame});
    return keys;
  }
  Keys all_keys() { return keys_of(animation()); }
  void click(const Vec2& where, Modifiers modifiers = {}) {
    headless_.hold(modifiers);
    headless_.click(where);
    headless_.settle();
    headless_.hold({});
  }
  void click_on(const std::string& words, const Vec2& beside = {0, 0}) {
    const auto where = headless_.find_words(words);
    ASSERT_TRUE(where) << words;
    click(*where + beside);
  }
  void go_to(int frame) { click({place().x_of(frame), place().area.y + 6}); }
  void choose_in_menu(const Vec2& where, const std::string& words) {
    headless_.press(where, Button::right);
    headless_.release(where, Button::right);
    headless_.settle();
    click_on(words);
  }
  void drag(const Vec2& from, const Vec2& to, Modifiers modifiers = {}, bool is_given_up = false) {
    headless_.hold(modifiers);
    headless_.press(from);
    headless_.move(from + (to - from) / 2);
    headless_.move(to);
    headless_.settle();
    if (is_given_up) headless_.key(Key::escape, modifiers);
    headless_.release(to);
    headless_.settle();
    headless_.hold({});
  }
  void type_over(const char* number) {
    headless_.key(Key::a, kControl);
    headless_.type(number);
    headless_.key(Key::enter);
    headless_.settle();
  }
  /// What was done is one step; undo takes it back and redo brings it again.
  void expect_one_step(const Animation& before, std::size_t steps_before) {
    const Animation after = animation();
    EXPECT_FALSE(after == before);
    EXPECT_EQ(steps(), steps_before + 1);
    headless_.key(Key::z, kControl);
    headless_.settle();
    EXPECT_EQ(animation(), before);
    headless_.key(Key::z, kControlShift);
    headless_.settle();
    EXPECT_EQ(animation(), after);
    headless_.key(Key::z, kControl);
    headless_.settle();
  }

  HeadlessEditor headless_{{1280, 800}};
};

TEST_F(TimeLineGestures, TheMenuCopiesPastesSelectsAllAndDeletes) {
  const Keys before = all_keys();
  choose_in_menu(depth_at(10), "Copy keys");
  go_to(18);
  choose_in_menu(depth_at(5), "Paste keys at the play head");
  Keys expected = before;
  expected.merge(depths({18}));
  EXPECT_EQ(all_keys(), expected);
  EXPECT_EQ(motion().keys().selected(), depths({18}));
  choose_in_menu(depth_at(18), "Delete handles or keys");
  EXPECT_EQ(all_keys(), before);
  choose_in_menu(depth_at(5), "Select all keys");
  EXPECT_EQ(motion().keys().selected(), before);
  EXPECT_EQ(editor().document().handles.size(), 2U);
}

TEST_F(TimeLineGestures, ABandWithShiftAddsToWhatIsSelected) {
  click(at(20, KeyedProperty::position));
  drag(depth_at(9) + Vec2(0, -6), depth_at(11) + Vec2(0, 6), {.shift = true});
  Keys expected = depths({10});
  expected.insert({1, KeyedProperty::position, 20});
  EXPECT_EQ(motion().keys().selected(), expected);
  drag(depth_at(9) + Vec2(0, -6), depth_at(11) + Vec2(0, 6));
  EXPECT_EQ(motion().keys().selected(), depths({10})) << "without it nothing else stays";
}

TEST_F(TimeLineGestures, EscapeGivesUpACopyAStretchAndABand) {
  const Animation before = animation();
  const std::size_t count = steps();
  drag(depth_at(10), depth_at(14), kControl, true);
  drag(depth_at(0) + Vec2(-9, -6), depth_at(11) + Vec2(0, 6));
  ASSERT_EQ(motion().keys().selected(), depths({0, 10}));
  drag(depth_at(10), depth_at(14), {.alt = true}, true);
  EXPECT_EQ(animation(), before);
  EXPECT_EQ(steps(), count);
  click(at(20, KeyedProperty::position));
  const Keys selected = motion().keys().selected();
  drag(depth_at(9) + Vec2(0, -6), depth_at(11) + Vec2(0, 6), {}, true);
  EXPECT_EQ(motion().keys().selected(), selected);
}

TEST_F(TimeLineGestures, CopyStretchAndPasteAreOneStepEach) {
  const Animation before = animation();
  const std::size_t count = steps();
  drag(depth_at(10), depth_at(14), kControl);
  EXPECT_EQ(animation().tracks[0].depth.size(), 3U);
  expect_one_step(before, count);
  drag(depth_at(0) + Vec2(-9, -6), depth_at(11) + Vec2(0, 6));
  drag(depth_at(10), depth_at(14), {.alt = true});
  EXPECT_EQ(animation().tracks[0].depth[1].frame, 14);
  expect_one_step(before, count);
  click(depth_at(10));
  headless_.key(Key::c, kControl);
  go_to(18);
  headless_.key(Key::v, kControl);
  headless_.settle();
  EXPECT_EQ(animation().tracks[0].depth.size(), 3U);
  expect_one_step(before, count);
}

TEST_F(TimeLineGestures, LengthRateAndLoopAreOneStepEach) {
  const Animation before = animation();
  const std::size_t count = steps();
  click_on("frames", {-50, 0});
  type_over("31");
  EXPECT_EQ(animation().cycle.frames, 31);
  expect_one_step(before, count);
  click_on("fps", {-40, 0});
  type_over("12.5");
  EXPECT_EQ(animation().fps, 12.5);
  expect_one_step(before, count);
  click_on("Loop");
  EXPECT_TRUE(animation().cycle.loops);
  expect_one_step(before, count);
}

/// From the left end of the panel, as they stand in their row.
constexpr double kPlayButton = 108, kRecordButton = 196, kKeyButton = 225, kOutlinesButton = 254;

TEST_F(TimeLineGestures, ButtonsPlayRecordSetKeysAndShowOutlines) {
  const auto press = [this](double x) {
    const Rectangle& panel = headless_.ui().layout().timeline;
    click({panel.x + x, panel.y + 20});
  };
  ASSERT_TRUE(motion().keys().records());
  press(kRecordButton);
  EXPECT_FALSE(motion().keys().records());
  press(kRecordButton);
  EXPECT_TRUE(motion().keys().records());
  press(kOutlinesButton);
  EXPECT_TRUE(motion().has_onion_skin());
  press(kOutlinesButton);
  EXPECT_FALSE(motion().has_onion_skin());
  go_to(5);
  editor().selection().select({1});
  headless_.settle();
  const Animation before = animation();
  const std::size_t count = steps();
  press(kKeyButton);
  EXPECT_EQ(all_keys().size(), keys_of(before).size() + 4);
  expect_one_step(before, count);
  const Rectangle& panel = headless_.ui().layout().timeline;
  headless_.click({panel.x + kPlayButton, panel.y + 20});
  EXPECT_TRUE(headless_.wait_until([this] { return motion().play_head().is_playing(); }));
  headless_.click({panel.x + kPlayButton, panel.y + 20});
  EXPECT_TRUE(headless_.wait_until([this] { return !motion().play_head().is_playing(); }));
}

TEST_F(TimeLineGestures, KeysOfTheKeyboardRecordAndGoFromKeyToKey) {
  headless_.key(Key::i, {.shift = true});
  EXPECT_FALSE(motion().keys().records());
  headless_.key(Key::i, {.shift = true});
  EXPECT_TRUE(motion().keys().records());
  motion().play_head().go_to(0);
  for (const int frame : {10, 16, 20, 20}) {
    headless_.key(Key::period, {.alt = true});
    EXPECT_EQ(motion().play_head().frame(), frame);
  }
  for (const int frame : {16, 10, 0, 0}) {
    headless_.key(Key::comma, {.alt = true});
    EXPECT_EQ(motion().play_head().frame(), frame);
  }
}

TEST_F(TimeLineGestures, TheCentreOfASwingIsDrawnAndPulledByItsGrip) {
  editor().selection().select({1});
  editor().selection().select({1, 0});
  headless_.calm_down();
  const Image without = headless_.canvas_picture();
  editor().run_command("motion.swing");
  headless_.calm_down();
  EXPECT_GT(differing_pixels(headless_.canvas_picture(), without), 100);
  const Animation before = animation();
  const std::size_t count = steps();
  ASSERT_EQ(before.groups.size(), 1U);
  const Rectangle& canvas = headless_.ui().layout().canvas;
  const Vec2 grip =
      Vec2(canvas.x, canvas.y) + swing_grip(editor().canvas(), before.groups[0].center);
  drag(grip, grip + Vec2(40, -20));
  const Vec2 moved = headless_.window_point(animation().groups[0].center) -
                     headless_.window_point(before.groups[0].center);
  EXPECT_NEAR((moved - Vec2(40, -20)).norm(), 0, 1e-4);
  expect_one_step(before, count);
}

}  // namespace
}  // namespace foldless::test
