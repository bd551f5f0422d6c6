// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/construct/carried_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/construct/cut_disk.h"
#include "core/mesh/orientation.h"

namespace foldless {
namespace {

constexpr int kCorners = 12;

/// On the unit circle, then random ones inside.
Points dotted_circle(std::uint64_t seed, int inside) {
  Points points(2, kCorners + inside);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    points.col(i) << std::cos(angle), std::sin(angle);
  }
  std::mt19937_64 random(seed);
  const auto any = [&] { return 1.2 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5); };
  for (int i = 0; i < inside; ++i) points.col(kCorners + i) << any(), any();
  return points;
}

CarriedCurves curves_of(const Points& points) {
  const auto disk =
      CutDisk::over(points.leftCols(kCorners), points.rightCols(points.cols() - kCorners));
  return {disk.value().triangles(), points};
}

/// In straight lines, in so many steps, each halved where triangles would fold.
void go(CarriedCurves& curves, const Points& from, const Points& to, double longest = 0.05) {
  double step = longest;
  for (double time = 0; time < 1;) {
    const double next = std::min(1.0, time + step);
    if (curves.move_to(next == 1 ? to : Points(from + next * (to - from)))) {
      time = next;
      step = longest;
    } else {
      step /= 2;
      ASSERT_GT(step, 1e-9);
    }
  }
}

/// So many turns of the first two points inside about their middle.
void twist(CarriedCurves& curves, const Points& home, int turns) {
  const Vec2 middle = 0.5 * (home.col(kCorners) + home.col(kCorners + 1));
  Points from = home;
  for (int i = 1; i <= 24; ++i) {
    const Eigen::Rotation2Dd turned(turns * 2 * std::numbers::pi * i / 24);
    Points to = home;
    for (const int v : {kCorners, kCorners + 1})
      to.col(v) = middle + turned * (home.col(v) - middle);
    if (i == 24) to = home;
    go(curves, from, to);
    from = to;
  }
}

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
  EXPECT_EQ(carried.crossing_count(), 0);
  EXPECT_EQ(carried.curves().size(), 3U * 5 + kCorners - 3);
  for (const CarriedCurves::Curve& curve : carried.curves()) EXPECT_EQ(curve.bends.cols(), 0);
}

TEST(CarriedCurves, NoTwoCrossWhereverPointsGo) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points from = dotted_circle(seed, 7), to = dotted_circle(seed + 100, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to);
    EXPECT_GT(carried.crossing_count(), 0);
    int bends = 0;
    for (const CarriedCurves::Curve& curve : carried.curves())
      bends += static_cast<int>(curve.bends.cols());
    EXPECT_EQ(bends, carried.crossing_count());
    expect_no_two_cross(carried, to);
  }
}

TEST(CarriedCurves, AreEdgesAgainWhenPointsWentBackOnTheirWay) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Points from = dotted_circle(seed, 7), to = dotted_circle(seed + 100, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to, 0.01);
    EXPECT_GT(carried.crossing_count(), 0);
    go(carried, to, from, 0.01);
    EXPECT_EQ(carried.crossing_count(), 0);
  }
}

TEST(CarriedCurves, ATurnOfTwoPointsIsUndoneByOneBackAndByNothingElse) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Points points = dotted_circle(seed, 4);
    points.col(kCorners + 1) = points.col(kCorners) + Vec2(0.02, 0.01);
    CarriedCurves carried = curves_of(points);
    twist(carried, points, 1);
    const int once = carried.crossing_count();
    EXPECT_GT(once, 0);
    expect_no_two_cross(carried, points);
    twist(carried, points, 1);
    EXPECT_GT(carried.crossing_count(), once);
    twist(carried, points, -2);
    EXPECT_EQ(carried.crossing_count(), 0);
  }
}

TEST(CarriedCurves, DoNotDependOnTheUnitOfLength) {
  const auto crossings = [](double unit) {
    const Points from = unit * dotted_circle(1, 7), to = unit * dotted_circle(101, 7);
    CarriedCurves carried = curves_of(from);
    go(carried, from, to);
    return carried.crossing_count();
  };
  for (const double unit : {0x1p-30, 0x1p30}) EXPECT_EQ(crossings(unit), crossings(1)) << unit;
}

TEST(CarriedCurves, StayWhereATriangleWouldFold) {
  Points points = dotted_circle(3, 5);
  CarriedCurves carried = curves_of(points);
  points.col(kCorners) = Vec2(3, 0);
  EXPECT_FALSE(carried.move_to(points));
  EXPECT_EQ(carried.crossing_count(), 0);
}

}  // namespace
}  // namespace foldless
