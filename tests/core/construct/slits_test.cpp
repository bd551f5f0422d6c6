// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/slits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/construct/compatible_triangulation.h"
#include "core/mesh/orientation.h"
#include "tests/support/dotted_disks.h"

namespace foldless {
namespace {

using test::dotted_disks;
using test::expect_banks_together;

TEST(Slits, LeaveTwoTriangulatedPolygonsWhoseCornersCorrespond) {
  for (std::uint64_t seed = 1; seed <= 15; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const int inside = 1 + static_cast<int>(seed % 7);
    const auto [rest, deformed] = dotted_disks(seed, inside);
    const std::vector<SlitDisks> ways = slit_open(rest, deformed);
    ASSERT_FALSE(ways.empty());
    for (const SlitDisks& disks : ways) {
      ASSERT_EQ(disks.rest.cols(), disks.deformed.cols());
      expect_banks_together(disks.rest, disks.vertices, rest);
      expect_banks_together(disks.deformed, disks.vertices, deformed);
      // A slit adds a corner for its tip and two for its root and for every bend.
      const auto corners = static_cast<int>(rest.outline.cols());
      const int bends = disks.vertex_count - corners - inside;
      EXPECT_EQ(disks.rest.cols(), corners + 2 * inside + 2 * bends);
      for (const auto& [points, triangles] :
           {std::pair(&disks.rest, &disks.rest_triangles),
            std::pair(&disks.deformed, &disks.deformed_triangles)}) {
        EXPECT_EQ(triangles->cols(), points->cols() - 2);
        for (const auto& t : triangles->colwise()) EXPECT_GT(orientation(*points, t), 0);
      }
    }
  }
}

TEST(Slits, ShortOnesComeFirstAndPointsThatStayGetStraightOnes) {
  const auto [rest, deformed] = dotted_disks(3, 6);
  const std::vector<SlitDisks> ways = slit_open(rest, deformed);
  EXPECT_TRUE(std::ranges::is_sorted(ways, {}, &SlitDisks::length));
  EXPECT_LT(ways.front().length, ways.back().length);
  for (const SlitDisks& disks : slit_open(rest, rest)) {
    EXPECT_EQ(disks.rest, disks.deformed);
    EXPECT_EQ(disks.vertex_count, rest.outline.cols() + rest.inside.cols()) << "no bends";
  }
}

TEST(Slits, PolygonsAreTriangulatedAnewSoThatFewerChordsCross) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const auto [rest, deformed] = dotted_disks(seed, 6);
    const SlitDisks disks = slit_open(rest, deformed).front();
    const auto as_given = compatible_triangulation(disks, 0);
    const auto anew = compatible_triangulation(disks, 1000);
    ASSERT_TRUE(as_given && anew);
    EXPECT_LT(2 * anew->vertex_count(), as_given->vertex_count());
  }
}

TEST(Slits, AreNoneWhereAPointIsNotInsideOrTheOutlineBoundsNoDisk) {
  const auto [rest, deformed] = dotted_disks(1, 2);
  DottedDisk outside = deformed;
  outside.inside.col(1) = Vec2(0, 1.5);
  EXPECT_TRUE(slit_open(rest, outside).empty());
  EXPECT_TRUE(slit_open(outside, deformed).empty());
  DottedDisk backwards = deformed;
  backwards.outline = deformed.outline.rowwise().reverse();
  EXPECT_TRUE(slit_open(rest, backwards).empty());
}

}  // namespace
}  // namespace foldless
