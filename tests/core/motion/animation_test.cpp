// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/animation.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

std::vector<Handle> three_handles() {
  std::vector<Handle> handles(3);
  for (int i = 0; i < 3; ++i) {
    handles[static_cast<std::size_t>(i)].id = 10 + i;
    handles[static_cast<std::size_t>(i)].vertex = i;
    handles[static_cast<std::size_t>(i)].target = Vec2(i, 0);
  }
  handles[1].turn = Turn{15, 0.5};
  return handles;
}

TEST(Animation, MovesWhatHasKeysAndNothingElse) {
  Animation animation;
  animation.cycle = {10, false};
  animation.tracks = {{.handle = 11,
                       .is_smooth = false,
                       .position = {{0, {0, 0}, {}}, {10, {10, 20}, {}}},
                       .angle = {{0, 0, {}}, {10, 90, {}}},
                       .depth = {{0, 1, {}}, {10, 2, {}}},
                       .weight = {{0, 3, {}}, {10, 5, {}}}}};
  const std::vector<Handle> before = three_handles();
  const std::vector<Handle> after = handles_at(animation, before, 5);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[2], before[2]);
  EXPECT_EQ(after[1].target, Vec2(5, 10));
  EXPECT_EQ(after[1].turn, (Turn{45, 0.5}));
  EXPECT_EQ(after[1].depth, 1.5);
  EXPECT_EQ(after[1].weight, 4);
}

TEST(Animation, AGroupSwingsTogether) {
  Animation animation;
  animation.cycle = {10, false};
  const auto from_right_to_left = [](int handle, double radius) {
    HandleTracks tracks;
    tracks.handle = handle;
    tracks.position = {{0, {1 + radius, 1}, {}}, {10, {1, 1 + radius}, {}}};
    return tracks;
  };
  animation.tracks = {from_right_to_left(10, 1), from_right_to_left(11, 3),
                      from_right_to_left(12, 3)};
  animation.groups = {{{1, 1}, {10, 11}}};
  const std::vector<Handle> handles = handles_at(animation, three_handles(), 5);
  EXPECT_NEAR((handles[0].target - Vec2(1, 1)).norm(), 1, 1e-14);
  EXPECT_NEAR((handles[1].target - Vec2(1, 1)).norm(), 3, 1e-14);
  EXPECT_TRUE(handles[2].target.isApprox(Vec2(2.5, 2.5))) << "not of the group: a straight line";
}

TEST(Animation, LosesWhatHasNoHandle) {
  Animation animation;
  animation.tracks = {{.handle = 10}, {.handle = 99}};
  animation.groups = {{{0, 0}, {99, 11}}, {{0, 0}, {99}}};
  const Animation kept = animation_of(animation, three_handles());
  ASSERT_EQ(kept.tracks.size(), 1U);
  EXPECT_EQ(kept.tracks[0].handle, 10);
  ASSERT_EQ(kept.groups.size(), 1U);
  EXPECT_EQ(kept.groups[0].handles, std::vector<int>{11});
  EXPECT_EQ(handles_at(animation, three_handles(), 3), three_handles());
}

}  // namespace
}  // namespace foldless
