// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/winding.h"
#include "tests/support/random_vector.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace foldless {
namespace {

Points polygon(const std::vector<Vec2>& corners) {
  Points points(2, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) = corners[i];
  return points;
}

const Points kUnitSquare = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});

TEST(TurningNumber, IsOneForSimplePolygonsAndMinusOneTheOtherWayRound) {
  EXPECT_EQ(turning_number(kUnitSquare), 1);
  EXPECT_EQ(turning_number(kUnitSquare.rowwise().reverse()), -1);
  EXPECT_EQ(turning_number(polygon({{0, 0}, {2, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}})), 1);
}

TEST(TurningNumber, IsZeroForAFigureOfEightAndCountsLoops) {
  EXPECT_EQ(turning_number(polygon({{0, 0}, {3, 3}, {3, 0}, {0, 3}})), 0);
  EXPECT_EQ(turning_number(polygon({{0, 0}, {9, 0}, {4, 6}, {2, 1}, {7, 1}, {5, 7}})), 2);
}

TEST(TurningNumber, CountsACornerThatGoesStraightBackAsHalfATurnToTheRight) {
  EXPECT_EQ(turning_number(polygon({{0, 0}, {1, 0}, {2, 0}, {1, 0}})), -1);
  // A spike out of a square takes two corners to the left and one half turn to the right.
  EXPECT_EQ(turning_number(polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 2}, {0.5, 1}, {0, 1}})),
            0);
  EXPECT_EQ(
      turning_number(polygon({{0, 0}, {1, 0}, {1, 1}, {0.5, 1}, {0.5, 0.5}, {0.5, 1}, {0, 1}})), 1)
      << "a slit: its end has the angle 2π";
}

TEST(GoesStraightBack, OnlyOnTheSameSideOfALine) {
  const Vec2 a(0.1, 0.3), b(1.1, 2.3);
  EXPECT_TRUE(goes_straight_back(a, b, a));
  EXPECT_TRUE(goes_straight_back({0, 0}, {2, 4}, {1, 2}));
  EXPECT_TRUE(goes_straight_back({0, 0}, {2, 4}, {-1, -2}));
  EXPECT_TRUE(goes_straight_back({3, 1}, {1, 1}, {7, 1}));
  EXPECT_FALSE(goes_straight_back({0, 0}, {2, 4}, {3, 6}));
  EXPECT_FALSE(goes_straight_back({3, 1}, {1, 1}, {0, 1}));
  EXPECT_FALSE(goes_straight_back({0, 0}, {2, 4}, {1, std::nextafter(2.0, 3)}));
}

TEST(TurningNumber, IsTheSumOfTheExteriorAngles) {
  const unsigned seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    Points points(2, 3 + round % 9);
    for (double& x : points.reshaped()) x = unit(random);
    double sum = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Vec2 at = points.col((i + 1) % points.cols());
      const Vec2 in = at - points.col(i), out = points.col((i + 2) % points.cols()) - at;
      sum += std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
    }
    ASSERT_NEAR(turning_number(points), sum / (2 * std::numbers::pi), 1e-6) << round;
  }
}

TEST(LeastWindingBeside, IsTheWindingNumberOffThePolygons) {
  EXPECT_EQ(least_winding_beside({kUnitSquare}, Vec2(0.5, 0.25)), 1);
  EXPECT_EQ(least_winding_beside({kUnitSquare}, Vec2(-1, 0)), 0);
  EXPECT_EQ(least_winding_beside({kUnitSquare}, Vec2(2, 1)), 0);
  EXPECT_EQ(least_winding_beside({kUnitSquare.rowwise().reverse()}, Vec2(0.5, 0.5)), -1);
  EXPECT_EQ(least_winding_beside({kUnitSquare, 3 * kUnitSquare}, Vec2(0.5, 0.5)), 2);
}

TEST(LeastWindingBeside, IsThatOfTheOutsideOnEdgesAndConvexCorners) {
  for (const Vec2& p : {Vec2(0.5, 0), Vec2(1, 0.5), Vec2(0.5, 1), Vec2(0, 0.5), Vec2(0, 0),
                        Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)})
    EXPECT_EQ(least_winding_beside({kUnitSquare}, p), 0) << p.transpose();
}

TEST(LeastWindingBeside, SeesOneUlp) {
  const double half = 0.5, ulp = 0x1p-53;
  const Points triangle = polygon({{0, 0}, {24, 24}, {0, 24}});
  EXPECT_EQ(least_winding_beside({triangle}, Vec2(half, half + ulp)), 1);
  EXPECT_EQ(least_winding_beside({triangle}, Vec2(half, half - ulp)), 0);
  EXPECT_EQ(least_winding_beside({triangle}, Vec2(half, half)), 0);
}

TEST(LeastWindingBeside, IsTheAngleThePolygonsTurnByRoundThePoint) {
  const unsigned seed = 11;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int round = 0; round < 2000; ++round) {
    Points points(2, 3 + round % 9);
    for (double& x : points.reshaped()) x = unit(random);
    const Vec2 p = test::random_vector(unit, random);
    double sum = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      const Vec2 a = points.col(i) - p, b = points.col((i + 1) % points.cols()) - p;
      sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    ASSERT_NEAR(least_winding_beside({points}, p), sum / (2 * std::numbers::pi), 1e-6) << round;
  }
}

TEST(IsAreaNegative, IsSaidOfThoseAloneThatAreSoWhateverTheRounding) {
  const Points back = kUnitSquare.rowwise().reverse();
  EXPECT_TRUE(is_area_negative({back}));
  EXPECT_FALSE(is_area_negative({kUnitSquare}));
  EXPECT_FALSE(is_area_negative({kUnitSquare, back}));
  EXPECT_TRUE(is_area_negative({kUnitSquare, 2 * back}));
  const Points far = back.colwise() + Vec2(1e9, 1e9);
  EXPECT_FALSE(is_area_negative({far})) << "an area of 1 among products of 1e18 is not known";
}

}  // namespace
}  // namespace foldless
