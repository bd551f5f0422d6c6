// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outline/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace foldless {
namespace {

using std::numbers::pi;

double spread_of_edge_lengths(const Loop& loop) {
  double shortest = 1e300, longest = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double length = (loop[(i + 1) % loop.size()] - loop[i]).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  return longest / shortest;
}

bool contains(const Loop& loop, const Vec2& p) {
  return std::any_of(loop.begin(), loop.end(),
                     [&](const Vec2& q) { return (p - q).norm() < 1e-12; });
}

TEST(RoundedPolygon, HasTheLengthOfItsLinesAndArcs) {
  const double r = 0.25;
  const Curve curve = rounded_polygon({{{0, 0}, r}, {{2, 0}, r}, {{2, 1}, r}, {{0, 1}, r}});
  EXPECT_NEAR(length_of(curve), 6 - 8 * r + 2 * pi * r, 1e-3);
  EXPECT_TRUE(curve.corners.empty());
}

TEST(RoundedPolygon, RadiiShrinkToTheRoomThereIs) {
  const Curve curve = rounded_polygon({{{0, 0}, 9}, {{1, 0}, 9}, {{1, 1}, 9}, {{0, 1}, 9}});
  EXPECT_NEAR(length_of(curve), pi, 1e-3);
  for (const Vec2& p : curve.points) EXPECT_NEAR((p - Vec2(0.5, 0.5)).norm(), 0.5, 1e-12);
}

TEST(RoundedPolygon, ConcaveCornersAreRoundedOnTheirInside) {
  const Curve curve = rounded_polygon({{{0, 0}, 0}, {{2, 0}, 0}, {{1, 0.5}, 0.2}, {{1, 2}, 0}});
  EXPECT_FALSE(contains(curve.points, {1, 0.5}));
  for (const Vec2& p : curve.points) EXPECT_LE(p.norm(), std::sqrt(5.0) + 1e-12);
  EXPECT_EQ(curve.corners.size(), 3u);
}

TEST(SmoothCurve, PassesThroughItsControlPoints) {
  const std::vector<ControlPoint> points{{{0, 0}, 1}, {{2, 0.3}, 1}, {{2, 2}, 0}, {{-1, 1}, 1}};
  const Curve curve = smooth_curve(points);
  for (const ControlPoint& p : points) EXPECT_TRUE(contains(curve.points, p.position));
  ASSERT_EQ(curve.corners.size(), 1u);
  EXPECT_EQ(curve.points[curve.corners[0]], Vec2(2, 2));
}

TEST(SmoothCurve, CornersOnlyIsThePolygon) {
  const Curve curve = smooth_curve({{{0, 0}, 0}, {{3, 0}, 0}, {{0, 4}, 0}});
  EXPECT_NEAR(length_of(curve), 12, 1e-12);
}

TEST(Circle, HasItsCircumference) { EXPECT_NEAR(length_of(circle({3, 4}, 2)), 4 * pi, 1e-3); }

TEST(Mirrored, RepeatsNoPointOfTheAxis) {
  const auto whole = mirrored({{{0, 0}, 1}, {{1, 1}, 2}, {{0, 2}, 3}});
  ASSERT_EQ(whole.size(), 4u);
  EXPECT_EQ(whole[3].position, Vec2(-1, 1));
  EXPECT_EQ(whole[3].radius, 2);
}

TEST(Resample, SpacesPointsEvenlyOnASmoothCurve) {
  const Loop loop = resample(circle({0, 0}, 1), 37);
  EXPECT_EQ(loop.size(), 37u);
  EXPECT_LT(spread_of_edge_lengths(loop), 1.001);
}

TEST(Resample, KeepsEveryCorner) {
  const Curve curve = smooth_curve({{{0, 0}, 0}, {{3, 0}, 0}, {{3, 0.1}, 0}, {{0, 4}, 1}});
  for (const int count : {3, 4, 10, 101}) {
    const Loop loop = resample(curve, count);
    EXPECT_EQ(static_cast<int>(loop.size()), count);
    for (const int corner : curve.corners) EXPECT_TRUE(contains(loop, curve.points[corner]));
  }
}

}  // namespace
}  // namespace foldless
