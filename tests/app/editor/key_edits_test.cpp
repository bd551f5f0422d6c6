// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editor/key_edits.h"

#include <gtest/gtest.h>

namespace foldless::test {
namespace {

constexpr auto kPosition = KeyedProperty::position;

/// Two handles; the first has keys at 0, 4 and 8, the second at 4, and turns.
Animation some_animation() {
  Animation animation;
  animation.cycle = {12, false};
  HandleTracks first, second;
  first.handle = 1;
  first.position = {{0, {0, 0}, {}}, {4, {4, 0}, *find_easing("in")}, {8, {8, 0}, {}}};
  second.handle = 2;
  second.angle = {{4, 90, {}}};
  animation.tracks = {first, second};
  return animation;
}

std::vector<int> frames_of(const Track<Vec2>& track) {
  std::vector<int> frames;
  for (const auto& key : track) frames.push_back(key.frame);
  return frames;
}

TEST(KeyEdits, KeysOfNamesAll) {
  EXPECT_EQ(
      keys_of(some_animation()),
      (Keys{
          {1, kPosition, 0}, {1, kPosition, 4}, {1, kPosition, 8}, {2, KeyedProperty::angle, 4}}));
}

TEST(KeyEdits, ANewKeyTakesTheEasingOfTheOneBeforeAndAnOldOneKeepsItsOwn) {
  Animation animation = some_animation();
  Handle handle;
  handle.id = 1;
  handle.target = {5, 5};
  set_key(animation, handle, kPosition, 6);
  set_key(animation, handle, kPosition, 4);
  const auto& track = animation.tracks[0].position;
  EXPECT_EQ(frames_of(track), (std::vector{0, 4, 6, 8}));
  EXPECT_EQ(track[2].easing, *find_easing("in"));
  EXPECT_EQ(track[1].value, Vec2(5, 5));
  EXPECT_EQ(track[1].easing, *find_easing("in"));
}

TEST(KeyEdits, AHandleThatDoesNotTurnGetsNoKeyOfItsAngle) {
  Animation animation = some_animation();
  Handle handle;
  handle.id = 7;
  set_key(animation, handle, KeyedProperty::angle, 3);
  EXPECT_EQ(animation, some_animation());
}

TEST(KeyEdits, TracksWithoutKeysGo) {
  Animation animation = some_animation();
  remove_keys(animation, {{2, KeyedProperty::angle, 4}, {1, kPosition, 0}});
  ASSERT_EQ(animation.tracks.size(), 1U);
  EXPECT_EQ(frames_of(animation.tracks[0].position), (std::vector{4, 8}));
}

TEST(KeyEdits, MovedKeysTakeTheirValuesAndWhatWasThereGoes) {
  Animation animation = some_animation();
  const Keys moved = move_keys(
      animation, {{1, kPosition, 0}, {1, kPosition, 4}}, [](int f) { return f + 4; }, false);
  const auto& track = animation.tracks[0].position;
  EXPECT_EQ(frames_of(track), (std::vector{4, 8}));
  EXPECT_EQ(track[0].value, Vec2(0, 0));
  EXPECT_EQ(track[1].value, Vec2(4, 0));
  EXPECT_EQ(track[1].easing, *find_easing("in"));
  EXPECT_EQ(moved, (Keys{{1, kPosition, 4}, {1, kPosition, 8}}));
}

TEST(KeyEdits, CopiedKeysStayWhereTheyWereToo) {
  Animation animation = some_animation();
  move_keys(
      animation, {{1, kPosition, 4}}, [](int f) { return f + 2; }, true);
  EXPECT_EQ(frames_of(animation.tracks[0].position), (std::vector{0, 4, 6, 8}));
}

TEST(KeyEdits, KeysStayWithinTheCycle) {
  Animation animation = some_animation();
  const auto far = [](int f) { return f + 100; };
  EXPECT_EQ(move_keys(animation, {{1, kPosition, 8}}, far, false), (Keys{{1, kPosition, 11}}));
  animation.cycle.loops = true;
  EXPECT_EQ(move_keys(animation, {{1, kPosition, 11}}, far, false), (Keys{{1, kPosition, 12}}));
  EXPECT_EQ(move_keys(
                animation, {{1, kPosition, 12}}, [](int) { return -3; }, false),
            (Keys{{1, kPosition, 0}}));
}

TEST(KeyEdits, AShorterCycleLosesTheKeysBehindItsEnd) {
  Animation animation = some_animation();
  set_cycle(animation, {8, false});
  EXPECT_EQ(frames_of(animation.tracks[0].position), (std::vector{0, 4}));
  EXPECT_EQ(animation.cycle, (Cycle{8, false}));
}

TEST(KeyEdits, EasingIsThatOfTheChosenKeysAlone) {
  Animation animation = some_animation();
  set_easing(animation, {{1, kPosition, 0}, {2, KeyedProperty::angle, 4}}, *find_easing("hold"));
  EXPECT_EQ(animation.tracks[0].position[0].easing, *find_easing("hold"));
  EXPECT_EQ(animation.tracks[0].position[1].easing, *find_easing("in"));
  EXPECT_EQ(animation.tracks[1].angle[0].easing, *find_easing("hold"));
}

}  // namespace
}  // namespace foldless::test
