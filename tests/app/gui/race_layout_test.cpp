// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/race_layout.h"

#include <gtest/gtest.h>

namespace foldless {
namespace {

class RaceLayoutFor : public testing::TestWithParam<float> {};

TEST_P(RaceLayoutFor, PartsLieInsideBesideEachOther) {
  for (const Rectangle area :
       {Rectangle{0, 28, 1280, 700}, Rectangle{0, 56, 2560, 1400}, Rectangle{0, 28, 500, 260}})
    for (const std::size_t count : {2U, 3U, 4U}) {
      const RaceLayout l = race_layout_for(area, count, GetParam());
      ASSERT_EQ(l.lanes.size(), count);
      float right = area.x;
      for (const RaceLayout::Lane& lane : l.lanes) {
        EXPECT_GE(lane.head.x, right);
        EXPECT_EQ(lane.view.width, l.lanes.front().view.width);
        EXPECT_EQ(lane.head.y, l.setup.y + l.setup.height);
        EXPECT_EQ(lane.view.y, lane.head.y + lane.head.height);
        EXPECT_EQ(lane.view.y + lane.view.height, l.results.y);
        EXPECT_GE(lane.view.height, 0);
        right = lane.view.x + lane.view.width;
      }
      EXPECT_LE(right, area.x + area.width);
      EXPECT_EQ(l.results.y + l.results.height, area.y + area.height);
    }
}

TEST_P(RaceLayoutFor, LeavesTheMeshesRoomOnAnOrdinaryWindow) {
  const float scale = GetParam();
  const Rectangle area{0, 0, 1280 * scale, 700 * scale};
  EXPECT_GE(race_layout_for(area, 4, scale).lanes.front().view.height, 250 * scale);
}

INSTANTIATE_TEST_SUITE_P(Scales, RaceLayoutFor, testing::Values(0.75F, 1.0F, 2.0F, 3.0F));

}  // namespace
}  // namespace foldless
