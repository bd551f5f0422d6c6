// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace foldless {
namespace {

TEST(Orientation, IsTheSignOfTheArea) {
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)), 1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(0, 1), Vec2(1, 0)), -1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)), 0);
}

// Points i + k ulp on the line y = x (Kettner et al.): b, c on the line, a beside it by ulps.
TEST(Orientation, IsRightOneUlpFromCollinear) {
  const Vec2 b(12, 12), c(24, 24);
  const double ulp = 0x1p-53;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      const Vec2 a(0.5 + i * ulp, 0.5 + j * ulp);
      EXPECT_EQ(orientation(a, b, c), (a.y() > a.x()) - (a.y() < a.x())) << i << ' ' << j;
    }
}

TEST(Orientation, SeesAreasThatUnderflow) {
  const double h = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(h, 0), Vec2(0, h)), 1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(0, h), Vec2(h, 0)), -1);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(h, h), Vec2(2 * h, 2 * h)), 0);
}

TEST(Orientation, SeesAreasThatOverflow) {
  const double h = std::numeric_limits<double>::max();
  EXPECT_EQ(orientation(Vec2(-h, -h), Vec2(h, -h), Vec2(-h, h)), 1);
  EXPECT_EQ(orientation(Vec2(-h, -h), Vec2(-h, h), Vec2(h, -h)), -1);
  EXPECT_EQ(orientation(Vec2(-h, -h), Vec2(0, 0), Vec2(h, h)), 0);
}

TEST(Orientation, IsZeroWhenACoordinateIsNotFinite) {
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, std::nan(""))), 0);
  EXPECT_EQ(orientation(Vec2(0, 0), Vec2(1, 0), Vec2(0, HUGE_VAL)), 0);
}

// On small integers the determinant is computed without rounding, whatever the scale.
TEST(Orientation, AgreesWithIntegersAndIsAntisymmetric) {
  const unsigned seed = 20240917;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<long long> coordinate(-40, 40);
  for (int i = 0; i < 20000; ++i) {
    long long p[6];
    for (long long& x : p) x = coordinate(random);
    const long long area = (p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0]);
    const double scale = std::ldexp(1.0, static_cast<int>(coordinate(random)) * 12);
    const auto at = [&](int k) {
      return Vec2(static_cast<double>(p[k]) * scale, static_cast<double>(p[k + 1]) * scale);
    };
    const Vec2 a = at(0), b = at(2), c = at(4);
    EXPECT_EQ(orientation(a, b, c), (area > 0) - (area < 0));
    EXPECT_EQ(orientation(b, c, a), orientation(a, b, c));
    EXPECT_EQ(orientation(b, a, c), -orientation(a, b, c));
    EXPECT_EQ(exact_orientation(a, b, c), orientation(a, b, c));
  }
}

}  // namespace
}  // namespace foldless
