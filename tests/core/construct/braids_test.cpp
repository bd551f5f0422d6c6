// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/braids.h"

#include <gtest/gtest.h>

#include "core/construct/compatible_triangulation.h"
#include "core/mesh/orientation.h"
#include "tests/support/dotted_disks.h"

namespace foldless {
namespace {

TEST(Braids, LeaveTwoPolygonsWhoseCornersCorrespondAndThatMapOntoEachOther) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int inside = 1 + static_cast<int>(seed % 6);
    const auto [rest, deformed] = test::dotted_disks(seed, inside);
    const auto disks = braided(rest, deformed, 0);
    ASSERT_TRUE(disks);
    ASSERT_EQ(disks->rest.cols(), disks->deformed.cols());
    test::expect_banks_together(disks->rest, disks->vertices, rest);
    test::expect_banks_together(disks->deformed, disks->vertices, deformed);
    // A slit adds a corner for its tip and two for its root and for every bend.
    const auto corners = static_cast<int>(rest.outline.cols());
    const int bends = disks->vertex_count - corners - inside;
    EXPECT_EQ(disks->rest.cols(), corners + 2 * inside + 2 * bends);
    const auto map = compatible_triangulation(*disks, 1000);
    ASSERT_TRUE(map);
    for (const auto& t : map->triangles().colwise()) {
      EXPECT_GT(orientation(map->rest(), t), 0);
      EXPECT_GT(orientation(map->deformed(), t), 0);
    }
  }
}

TEST(Braids, SlitsAreStraightWherePointsStay) {
  DottedDisk disk = test::dotted_disks(1, 6).first;
  const auto disks = braided(disk, disk, 0);
  ASSERT_TRUE(disks);
  EXPECT_EQ(disks->rest, disks->deformed);
  EXPECT_EQ(disks->rest.cols(), disk.outline.cols() + 2 * disk.inside.cols());
}

TEST(Braids, TheSameSearchFindsTheSameAndOthersOftenFindOthers) {
  int others = 0;
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    const auto [rest, deformed] = test::dotted_disks(seed, 10);
    const auto first = braided(rest, deformed, 0), again = braided(rest, deformed, 0);
    const auto other = braided(rest, deformed, 1);
    ASSERT_TRUE(first && again && other);
    EXPECT_EQ(first->deformed, again->deformed);
    if (first->deformed.cols() != other->deformed.cols()) ++others;
  }
  EXPECT_GE(others, 1);
}

TEST(Braids, AreNothingWherePointsCannotGoRoundACorner) {
  DottedDisk rest;
  rest.outline.resize(2, 8);                 // a narrow U
  rest.outline << 0, 10, 10, 9, 9, 1, 1, 0,  //
      0, 0, 10, 10, 1, 1, 10, 10;
  rest.inside.resize(2, 1);
  rest.inside << 0.5, 9;
  DottedDisk deformed = rest;
  deformed.inside << 9.5, 9;
  EXPECT_FALSE(braided(rest, deformed, 0));
  EXPECT_FALSE(slit_open(rest, deformed).empty());
}

TEST(Braids, AreNothingWhereAPointIsOutside) {
  auto [rest, deformed] = test::dotted_disks(1, 3);
  deformed.inside.col(0) << 5, 5;
  EXPECT_FALSE(braided(rest, deformed, 0));
  EXPECT_FALSE(braided(deformed, rest, 0));
}

}  // namespace
}  // namespace foldless
