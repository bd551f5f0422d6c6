// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/level_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/outline/loops.h"

namespace foldless {
namespace {

ScalarGrid grid_of(int width, std::vector<float> values) {
  ScalarGrid grid(width, static_cast<int>(values.size()) / width);
  grid.values = std::move(values);
  return grid;
}

TEST(LevelSet, IsARoundCircleForADistance) {
  ScalarGrid field(40, 40);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x)
      field.at(x, y) = static_cast<float>(11.3 - std::hypot(x + 0.5 - 20, y + 0.5 - 18));
  const std::vector<Loop> loops = level_set(field);
  ASSERT_EQ(loops.size(), 1U);
  for (const Vec2& p : loops[0]) EXPECT_NEAR((p - Vec2(20, 40 - 18)).norm(), 11.3, 0.03);
  EXPECT_NEAR(area_of(loops[0]), 3.14159 * 11.3 * 11.3, 2);
}

TEST(LevelSet, OfAFullGridIsItsRectangle) {
  const std::vector<Loop> loops = level_set(ScalarGrid(5, 3, 7));
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(area_of(loops[0]), 15);
  for (const Vec2& corner : {Vec2(0, 0), Vec2(5, 0), Vec2(5, 3), Vec2(0, 3)})
    EXPECT_NE(std::ranges::find(loops[0], corner), loops[0].end()) << corner.transpose();
}

TEST(LevelSet, HasTheRegionOnItsLeft) {
  ScalarGrid ring(5, 5, 1);
  ring.at(2, 2) = -1;
  const std::vector<Loop> loops = level_set(ring);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(area_of(loops[0]), 25);
  EXPECT_EQ(area_of(loops[1]), -0.5);
}

TEST(LevelSet, JoinsCellsAtACornerByTheMeanOfFour) {
  EXPECT_EQ(level_set(grid_of(2, {1, -3, -3, 1})).size(), 2U);
  EXPECT_EQ(level_set(grid_of(2, {-3, 1, 1, -3})).size(), 2U);
  EXPECT_EQ(level_set(grid_of(2, {3, -1, -1, 3})).size(), 1U);
  EXPECT_EQ(level_set(grid_of(2, {-1, 3, 3, -1})).size(), 1U);
}

TEST(LevelSet, OfNothingIsEmpty) {
  EXPECT_TRUE(level_set(ScalarGrid(4, 4, -1)).empty());
  EXPECT_TRUE(level_set(ScalarGrid(4, 4, 0)).empty());
}

}  // namespace
}  // namespace foldless
