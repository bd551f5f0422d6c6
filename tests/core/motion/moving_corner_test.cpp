// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion/moving_corner.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/mesh/orientation.h"

namespace foldless {
namespace {

/// The apex stays at the origin.
MovingCorner corner(const MovingPoint& first, const MovingPoint& second) {
  return {{}, first, second};
}

constexpr int kSamples = 48;

/// Corners with small integers as coordinates are integers at every sampled moment, kSamples times
/// as large: predicates on them are exact.
Vec2 sample(const MovingPoint& p, int i) { return (kSamples - i) * p.from + i * p.to; }

int orientation_at(const MovingCorner& c, int i) {
  return orientation(sample(c.apex, i), sample(c.first, i), sample(c.second, i));
}

double dot_at(const MovingCorner& c, int i) {
  return (sample(c.first, i) - sample(c.apex, i)).dot(sample(c.second, i) - sample(c.apex, i));
}

MovingPoint random_point(std::mt19937& random) {
  std::uniform_int_distribution<int> integer(-6, 6);
  const auto place = [&] { return Vec2(integer(random), integer(random)); };
  const Vec2 from = place();
  return {from, place()};
}

MovingCorner random_corner(std::mt19937& random) {
  const MovingPoint apex = random_point(random), first = random_point(random);
  return {apex, first, random_point(random)};
}

TEST(MovingCorner, ATriangleThatIsTurnedByHalfATurnIsFlatHalfWay) {
  const MovingCorner c = corner({{1, 0}, {-1, 0}}, {{0, 1}, {0, -1}});
  ASSERT_TRUE(first_flat_moment(c));
  EXPECT_EQ(*first_flat_moment(c), 0.5) << "a double root: its area is never negative";
}

TEST(MovingCorner, ATriangleThatIsNearlyFlatForAMomentIsNot) {
  for (const double rest : {1e-3, 1e-9, 1e-20, 1e-100, 1e-200, 1e-300}) {
    const MovingCorner c = corner({{1, rest}, {-1, rest}}, {{-rest, 1}, {-rest, -1}});
    EXPECT_EQ(first_flat_moment(c), std::nullopt) << rest << ": (1 − 2 t)² + rest²";
  }
  const double rest = 1e-9;
  const MovingCorner c = corner({{1, rest}, {-1, rest}}, {{rest, 1}, {rest, -1}});
  EXPECT_NEAR(first_flat_moment(c).value_or(-1), 0.5, 1e-9) << "(1 − 2 t)² − rest²";
}

TEST(MovingCorner, TheFirstOfTwoFlatMomentsIsTold) {
  // The sides are 1 − 4 t and 3 − 4 t times the unit vectors: the area is negative in between.
  const MovingCorner c = corner({{1, 0}, {-3, 0}}, {{0, 3}, {0, -1}});
  EXPECT_NEAR(first_flat_moment(c).value_or(-1), 0.25, 1e-15);
}

TEST(MovingCorner, ATriangleThatIsFlatAtAnEndFailsThere) {
  EXPECT_EQ(first_flat_moment(corner({{1, 0}, {1, 0}}, {{0, 1}, {1, 0}})), 1);
  EXPECT_EQ(first_flat_moment(corner({{1, 0}, {1, 0}}, {{1, 0}, {0, 1}})), 0);
  EXPECT_EQ(first_flat_moment(corner({{1, 0}, {1, 0}}, {{0, -1}, {0, 1}})), 0);
}

TEST(MovingCorner, WhatIsNotFiniteFailsAtOnce) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    EXPECT_EQ(first_flat_moment(corner({{1, 0}, {1, bad}}, {{0, 1}, {0, 1}})), 0);
    EXPECT_EQ(first_closed_moment(corner({{1, 0}, {bad, 0}}, {{0, 1}, {0, 1}})), 0);
  }
  EXPECT_EQ(first_flat_moment(corner({{1e200, 0}, {1e200, 0}}, {{0, 1e200}, {0, 1e200}})),
            std::nullopt)
      << "areas that overflow are decided exactly";
  EXPECT_EQ(first_flat_moment(corner({{1e-200, 0}, {1e-200, 0}}, {{0, 1e-200}, {0, 1e-200}})),
            std::nullopt)
      << "and those that underflow";
}

TEST(MovingCorner, FlatMomentsAgreeWithThoseThatAreSampled) {
  std::mt19937 random(7);
  int flat_between = 0, positive = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const MovingCorner c = random_corner(random);
    const auto moment = first_flat_moment(c);
    const double first = moment.value_or(2);
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      if (t >= first - 1e-12) break;
      ASSERT_GT(orientation_at(c, i), 0) << "trial " << trial << ", moment " << t;
    }
    if (!moment) ++positive;
    if (moment && orientation_at(c, 0) > 0 && orientation_at(c, kSamples) > 0) ++flat_between;
    if (moment && *moment > 0) {
      const auto at = [&](const MovingPoint& p) -> Vec2 {
        return (1 - *moment) * p.from + *moment * p.to;
      };
      EXPECT_NEAR(signed_area(at(c.apex), at(c.first), at(c.second)), 0, 1e-12) << trial;
    }
  }
  EXPECT_GT(positive, 2000);
  EXPECT_GT(flat_between, 500) << "both ends are well, but not what is between";
}

TEST(MovingCorner, SidesInOppositeDirectionsAreNotClosed) {
  // The first side stays, the second swings from 90° to 270°, by 180°.
  const MovingPoint stays{{1, 0}, {1, 0}};
  EXPECT_EQ(first_closed_moment(corner(stays, {{-1, 1}, {-1, -1}})), std::nullopt);
  EXPECT_EQ(first_closed_moment(corner(stays, {{1, -1}, {1, 1}})), 0.5);
  EXPECT_EQ(first_closed_moment(corner(stays, {{3, -1}, {-1, 3}})), 0.25);
  EXPECT_EQ(first_closed_moment(corner(stays, {{1, -1}, {1, 0}})), 1);
  EXPECT_EQ(first_closed_moment(corner(stays, {{2, 0}, {1, 1}})), 0);
}

TEST(MovingCorner, AnIrrationalMomentIsFound) {
  // (1, t) and (1 + t, 1) are parallel where t² + t = 1.
  const MovingCorner c = corner({{1, 0}, {1, 1}}, {{1, 1}, {2, 1}});
  EXPECT_NEAR(first_closed_moment(c).value_or(-1), (std::sqrt(5.0) - 1) / 2, 1e-15);
}

TEST(MovingCorner, SidesThatTouchForAMomentAreClosed) {
  // With s = 1 − 2 t the determinant of (1, −s) and (s + 2, rest − 2 s) is s² + rest.
  const auto with = [](double rest) {
    return corner({{1, -1}, {1, 1}}, {{3, rest - 2}, {1, rest + 2}});
  };
  EXPECT_EQ(first_closed_moment(with(0)), 0.5) << "the determinant is never negative";
  EXPECT_EQ(first_closed_moment(with(0x1p-51)), std::nullopt);
  EXPECT_NEAR(first_closed_moment(with(-0x1p-50)).value_or(-1), 0.5, 1e-7);
}

TEST(MovingCorner, SidesOnOneLineForEverAreClosedOrNeverAre) {
  const MovingPoint side{{1, 2}, {2, 4}};
  EXPECT_EQ(first_closed_moment(corner(side, {{2, 4}, {3, 6}})), 0);
  EXPECT_EQ(first_closed_moment(corner(side, {{-2, -4}, {-3, -6}})), std::nullopt);
}

TEST(MovingCorner, ClosedMomentsAgreeWithThoseThatAreSampled) {
  std::mt19937 random(8);
  int closed = 0, open = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const MovingCorner c = random_corner(random);
    const auto at = [](const MovingPoint& p, double t) -> Vec2 {
      return (1 - t) * p.from + t * p.to;
    };
    const auto sides = [&](double t) {
      return std::array{Vec2(at(c.first, t) - at(c.apex, t)),
                        Vec2(at(c.second, t) - at(c.apex, t))};
    };
    const auto moment = first_closed_moment(c);
    (moment ? closed : open)++;
    if (moment) {
      const auto [a, b] = sides(*moment);
      EXPECT_NEAR(cross(a, b), 0, 1e-12) << trial;
      EXPECT_GT(a.dot(b), -1e-12) << trial;
    }
    for (int i = 0; i <= kSamples && i < kSamples * moment.value_or(2) - 1e-9; ++i)
      ASSERT_FALSE(orientation_at(c, i) == 0 && dot_at(c, i) > 0) << trial << ", sample " << i;
    // One side passes the other, both looking one way: never before the moment.
    constexpr int kSteps = 1000;
    double before = 0;
    for (int i = 0; i <= kSteps && i < kSteps * moment.value_or(2) - 1; ++i) {
      const auto [a, b] = sides(static_cast<double>(i) / kSteps);
      const double now = a.dot(b) > 1 ? cross(a, b) : 0;
      ASSERT_GE(before * now, 0) << trial << ", step " << i;
      before = now;
    }
  }
  EXPECT_GT(closed, 300);
  EXPECT_GT(open, 300);
}

}  // namespace
}  // namespace foldless
