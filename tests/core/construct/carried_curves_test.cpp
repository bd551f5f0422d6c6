// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/carried_curves.h"

#include <gtest/gtest.h>

#include "core/mesh/orientation.h"
#include "tests/support/carried_points.h"

namespace foldless {
namespace {

using namespace test;

std::vector<Vec2> points_along(const CarriedCurves::Curve& curve, const Points& points) {
  std::vector<Vec2> along{points.col(curve.from)};
  for (const Vec2 bend : curve.bends.colwise()) along.push_back(bend);
  along.push_back(points.col(curve.to));
  return along;
}

bool do_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

void expect_no_two_cross(const CarriedCurves& carried, const Points& points) {
  std::vector<std::pair<Vec2, Vec2>> pieces;
  for (const CarriedCurves::Curve& curve : carried.curves()) {
    const std::vector<Vec2> along = points_along(curve, points);
    for (std::size_t i = 1; i < along.size(); ++i) pieces.emplace_back(along[i - 1], along[i]);
  }
  int crossings = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (do_cross(pieces[i].first, pieces[i].second, pieces[j].first, pieces[j].second))
        ++crossings;
  EXPECT_EQ(crossings, 0) << "of " << pieces.size() << " pieces";
}

TEST(CarriedCurves, AreEdgesUntilAPointMoves) {
  const CarriedCurves carried = curves_of(dotted_circle(1, 5));
  EXPECT_EQ(crossings_of(carried), 0);
  EXPECT_EQ(carried.curves().size(), 3U * 5 + kCorners - 3);
  for (const CarriedCurves::Curve& curve : carried.curves()) EXPECT_EQ(curve.bends.cols(), 0);
}

TEST(CarriedCurves, NoTwoCrossWhereverPointsGo) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points from = dotted_circle(seed, 7), to = dotted_circle(seed + 100, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to);
    EXPECT_GT(crossings_of(carried), 0);
    expect_no_two_cross(carried, to);
  }
}

TEST(CarriedCurves, AreEdgesAgainWhenPointsWentBackOnTheirWay) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points from = dotted_circle(seed, 7), to = dotted_circle(seed + 100, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to, 0.01);
    EXPECT_GT(crossings_of(carried), 0);
    go(carried, to, from, 0.01);
    EXPECT_EQ(crossings_of(carried), 0);
  }
}

TEST(CarriedCurves, ATurnOfTwoPointsIsUndoneByOneBackAndByNothingElse) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Points points = dotted_circle(seed, 4);
    points.col(kCorners + 1) = points.col(kCorners) + Vec2(0.02, 0.01);
    CarriedCurves carried = curves_of(points);
    twist(carried, points, 1);
    const int once = crossings_of(carried);
    EXPECT_GT(once, 0);
    expect_no_two_cross(carried, points);
    twist(carried, points, 1);
    EXPECT_GT(crossings_of(carried), once);
    twist(carried, points, -2);
    EXPECT_EQ(crossings_of(carried), 0);
  }
}

TEST(CarriedCurves, DoNotDependOnTheUnitOfLength) {
  const auto crossings = [](double unit) {
    const Points from = unit * dotted_circle(1, 7), to = unit * dotted_circle(101, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to);
    return crossings_of(carried);
  };
  for (const double unit : {0x1p-30, 0x1p30}) EXPECT_EQ(crossings(unit), crossings(1)) << unit;
}

TEST(CarriedCurves, StayWhereATriangleWouldFold) {
  Points points = dotted_circle(3, 5);
  CarriedCurves carried = curves_of(points);
  points.col(kCorners) = Vec2(3, 0);
  EXPECT_FALSE(carried.move_to(points));
  EXPECT_EQ(crossings_of(carried), 0);
}

}  // namespace
}  // namespace foldless
