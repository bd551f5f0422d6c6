// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/specks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foldless {
namespace {

/// A piece of four cells, three of which touch at corners, one of two, and one of one.
ScalarGrid three_pieces() {
  ScalarGrid grid(8, 4, -1);
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 1}, {2, 2}, {3, 2}, {6, 0}, {6, 1}, {7, 3}})
    grid.at(x, y) = 2;
  return grid;
}

auto positive(const ScalarGrid& grid) {
  return std::ranges::count_if(grid.values, [](float value) { return value > 0; });
}

TEST(Specks, PiecesOfFewerCellsGo) {
  ScalarGrid grid = three_pieces();
  EXPECT_EQ(remove_specks(grid, 2), 1);
  EXPECT_EQ(positive(grid), 6);
  EXPECT_LT(grid.at(7, 3), 0);
  EXPECT_EQ(remove_specks(grid, 3), 1);
  EXPECT_EQ(positive(grid), 4);
}

TEST(Specks, TheLargestPieceStays) {
  ScalarGrid grid = three_pieces();
  EXPECT_EQ(remove_specks(grid, 100), 2);
  EXPECT_EQ(positive(grid), 4);
  EXPECT_GT(grid.at(3, 2), 0);
}

TEST(Specks, NothingHasNone) {
  ScalarGrid grid(3, 3, -1);
  EXPECT_EQ(remove_specks(grid, 5), 0);
}

}  // namespace
}  // namespace foldless
