// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/polygon_clip.h"

#include <gtest/gtest.h>

#include <cmath>

namespace foldless {
namespace {

const Box kUnit{{0, 0}, {1, 1}};

double area_of(const Polygon& polygon) {
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return 0.5 * doubled;
}

TEST(PolygonClip, KeepsWhatIsInsideAsItIs) {
  const Polygon triangle{{0.1, 0.1}, {0.9, 0.2}, {0.3, 0.8}};
  EXPECT_EQ(clipped(triangle, kUnit), triangle);
}

TEST(PolygonClip, OfABoxTilingAddsUpToTheWhole) {
  const Polygon triangle{{-0.7, 0.3}, {2.6, -1.1}, {1.2, 2.9}};
  double sum = 0;
  for (int y = -2; y < 4; ++y)
    for (int x = -2; x < 4; ++x) {
      const Polygon part = clipped(triangle, {{x, y}, {x + 1, y + 1}});
      EXPECT_GE(area_of(part), 0);
      for (const glm::dvec2& p : part) EXPECT_TRUE(p.x >= x && p.x <= x + 1 && p.y >= y);
      sum += area_of(part);
    }
  EXPECT_NEAR(sum, area_of(triangle), 1e-12);
}

TEST(PolygonClip, LeavesNothingOfWhatIsOutside) {
  EXPECT_TRUE(clipped({{2, 0}, {3, 0}, {2, 1}}, kUnit).empty());
  EXPECT_FALSE(may_meet({{2, 0}, {3, 0}, {2, 1}}, kUnit));
  EXPECT_TRUE(may_meet({{-5, -5}, {5, -5}, {0, 9}}, kUnit));
}

TEST(PolygonClip, CutsLinesWhereTheyLeaveTheBox) {
  const auto line = clipped_line({-1e6, 0.5}, {0.5, 0.5}, kUnit);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->first.x, 0, 1e-9);
  EXPECT_EQ(line->second, glm::dvec2(0.5, 0.5));
  EXPECT_FALSE(clipped_line({-1, 0.5}, {0.5, 3}, kUnit));
  EXPECT_FALSE(clipped_line({0, 2}, {1, 2}, kUnit));
}

}  // namespace
}  // namespace foldless
