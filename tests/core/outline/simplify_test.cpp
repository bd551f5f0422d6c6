// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/simplify.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/outline/curve.h"
#include "core/outline/loops.h"

namespace foldless {
namespace {

double distance_from(const Vec2& p, const Loop& loop) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], along = loop[(i + 1) % loop.size()] - a;
    const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (p - a - t * along).norm());
  }
  return nearest;
}

TEST(Simplify, LeavesCornersOutWithinTheDistance) {
  const Loop round = circle({3, 4}, 10).points;
  const Loop simple = simplified({round}, 0.2)[0];
  EXPECT_LT(simple.size(), 40U);
  EXPECT_GE(simple.size(), 10U);
  for (const Vec2& p : round) EXPECT_LE(distance_from(p, simple), 0.2 + 1e-12);
}

TEST(Simplify, KeepsNestedLoopsApart) {
  // Two circles that are closer than the distance: alone, each would cross the other.
  const std::vector<Loop> rings{circle({0, 0}, 10).points, circle({0, 0}, 9.9).points};
  const std::vector<Loop> simple = simplified(rings, 2);
  ASSERT_EQ(simple.size(), 2U);
  const Shape shape = triangulate({simple[0], {simple[1]}}, {.min_angle = 0});
  EXPECT_GT(shape.triangles.cols(), 0);
}

TEST(Simplify, NeverLeavesLessThanATriangle) {
  const std::vector<Loop> simple =
      simplified({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, circle({9, 9}, 1).points}, 1000);
  EXPECT_EQ(simple[0].size(), 3U);
  EXPECT_EQ(simple[1].size(), 3U);
  EXPECT_GT(area_of(simple[0]), 0);
  EXPECT_GT(area_of(simple[1]), 0);
}

TEST(Simplify, WithoutADistanceOnlyStraightCornersGo) {
  const Loop simple = simplified({{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2.0001}, {0, 2}}}, 0)[0];
  EXPECT_EQ(simple.size(), 5U);
}

}  // namespace
}  // namespace foldless
